"""Ensembles: one scene in many worlds, on all cores or many machines, as one dataset.

Serves: users who ask how sure an answer is. Hides: how worlds are drawn, where they are computed,
and how results are kept.
"""

from tamias2d.ensemble.dataset import world_scene
from tamias2d.ensemble.mean import Mean, ensemble_mean
from tamias2d.ensemble.run_ensemble import ensemble
from tamias2d.ensemble.sampling import Grid, random_stream
from tamias2d.ensemble.sensitivity import sensitivities
from tamias2d.ensemble.simulators import Simulators
from tamias2d.ensemble.world_reports import WorldContacts

__all__ = [
    "Grid",
    "Mean",
    "Simulators",
    "WorldContacts",
    "ensemble",
    "ensemble_mean",
    "random_stream",
    "sensitivities",
    "world_scene",
]
