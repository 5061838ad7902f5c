"""Tamias2D: 2D rigid-body physics, generated from its requirements specification.

Serves: the public names, at little cost. Hides: their modules, each loaded when a name of it is
first used.
"""

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the same names as below, for readers, editors and type checkers
    from tamias2d.certificate import Certificate as Certificate
    from tamias2d.cost import Cost as Cost
    from tamias2d.engine.reports.contact_report import Contacts as Contacts
    from tamias2d.ensemble import (
        Grid as Grid,
        Mean as Mean,
        Simulators as Simulators,
        WorldContacts as WorldContacts,
        ensemble as ensemble,
        ensemble_mean as ensemble_mean,
        random_stream as random_stream,
        sensitivities as sensitivities,
        world_scene as world_scene,
    )
    from tamias2d.errors import (
        ArgumentError as ArgumentError,
        InputError as InputError,
        RecordingError as RecordingError,
        SceneError as SceneError,
        SimulationError as SimulationError,
        SpecError as SpecError,
        StepWarning as StepWarning,
        TamiasError as TamiasError,
    )
    from tamias2d.motion import (
        ClosedForm as ClosedForm,
        Dop853 as Dop853,
        DormandPrince5 as DormandPrince5,
        ExplicitEuler as ExplicitEuler,
        ExponentialDrag as ExponentialDrag,
        JointError as JointError,
        JointEvent as JointEvent,
        JointEvents as JointEvents,
        Legacy2018 as Legacy2018,
        Reactions as Reactions,
        Reference as Reference,
        RungeKutta4 as RungeKutta4,
        SemiImplicitEuler as SemiImplicitEuler,
        StabilityError as StabilityError,
        Stepped as Stepped,
        StepSizeError as StepSizeError,
        VelocityVerlet as VelocityVerlet,
        Yoshida4 as Yoshida4,
    )
    from tamias2d.record.recorder import Recorder as Recorder
    from tamias2d.run import Run as Run
    from tamias2d.run_data import Impacts as Impacts
    from tamias2d.scene import (
        Body as Body,
        Box as Box,
        Capsule as Capsule,
        Chain as Chain,
        Compound as Compound,
        Disc as Disc,
        Distance as Distance,
        Equation as Equation,
        Gear as Gear,
        Groove as Groove,
        HalfPlane as HalfPlane,
        JointSpring as JointSpring,
        Limits as Limits,
        Motor as Motor,
        Part as Part,
        Polygon as Polygon,
        Prismatic as Prismatic,
        Pulley as Pulley,
        Ratchet as Ratchet,
        Revolute as Revolute,
        Rotary as Rotary,
        Scene as Scene,
        Segment as Segment,
        Target as Target,
        Weld as Weld,
        Wheel as Wheel,
        catalogue as catalogue,
        load as load,
        needs as needs,
        scene_text as scene_text,
    )
    from tamias2d.simulate import simulate as simulate
    from tamias2d.simulator import Hits as Hits, Simulator as Simulator
    from tamias2d.study.certify import certify as certify
    from tamias2d.study.recommend import recommend as recommend
    from tamias2d.study.refusal import ToleranceError as ToleranceError
    from tamias2d.trace import trace as trace
    from tamias2d.verify import verify as verify
    from tamias2d.work_limit import WorkLimitError as WorkLimitError

    __version__: str

_HOMES = {
    "certificate": "Certificate",
    "cost": "Cost",
    "engine.reports.contact_report": "Contacts",
    "ensemble": "Grid Mean Simulators WorldContacts ensemble ensemble_mean random_stream "
    "sensitivities world_scene",
    "errors": "ArgumentError InputError RecordingError SceneError SimulationError SpecError "
    "StepWarning TamiasError",
    "motion": "ClosedForm Dop853 DormandPrince5 ExplicitEuler ExponentialDrag JointError "
    "JointEvent JointEvents Legacy2018 Reactions Reference RungeKutta4 SemiImplicitEuler "
    "StabilityError StepSizeError Stepped VelocityVerlet Yoshida4",
    "record.recorder": "Recorder",
    "run": "Run",
    "run_data": "Impacts",
    "scene": "Body Box Capsule Chain Compound Disc Distance Equation Gear Groove HalfPlane "
    "JointSpring Limits Motor Part Polygon Prismatic Pulley Ratchet Revolute Rotary Scene Segment "
    "Target Weld Wheel catalogue load needs scene_text",
    "simulate": "simulate",
    "simulator": "Hits Simulator",
    "study.certify": "certify",
    "study.recommend": "recommend",
    "study.refusal": "ToleranceError",
    "trace": "trace",
    "verify": "verify",
    "work_limit": "WorkLimitError",
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names.split()}


def __getattr__(name: str) -> object:
    value = _value(name)
    globals()[name] = value
    return value


def _value(name: str) -> object:
    if name == "__version__":
        from importlib.metadata import version

        return version("tamias2d")
    if name not in _HOME_OF:
        raise AttributeError(f"t2.{name}: unknown{_meant(name)}", name=name)
    return getattr(import_module(f"tamias2d.{_HOME_OF[name]}"), name)


def _meant(name: str) -> str:
    from tamias2d.suggestions import nearest

    near = nearest(name, _HOME_OF)
    return f"; did you mean t2.{near}?" if near else ". dir(tamias2d) lists what there is."


def __dir__() -> list[str]:
    return [*globals(), *_HOME_OF, "__version__"]


class _Package(ModuleType):
    """Keeps `tamias2d.simulate` the function: importing its module would put itself there."""

    def __setattr__(self, name: str, value: object) -> None:
        if not (name in _HOME_OF and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package
