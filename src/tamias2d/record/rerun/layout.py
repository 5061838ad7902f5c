"""The entities of a recording, and the layout of the viewer's window."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import rerun as rr
import rerun.blueprint as rrb

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rerun.datatypes import EntityPath

    from tamias2d.record.drawing import View
    from tamias2d.run_data import RunData

RECORDING = "/recording"
WORLD = "/world"
BODIES = "/world/bodies"
IMPACTS = "/world/impacts"
IMPACT_LOG, JOINT_LOG = "/impacts", "/impacts/joints"
JOINTS = "/world/joints"
REACTIONS = "/world/reactions"
JOINT_EVENTS = "/joint_events"
ABOUT, MODELS, SCENE = "/about", "/models", "/scene"
ENERGY, MOMENTUM, SPIN = "/plots/energy", "/plots/momentum", "/plots/angular_momentum"
SPEED, COUNT = "/plots/speed", "/plots/bodies"

FRAME_SERIES = {ENERGY: ["kinetic"], SPEED: ["fastest", "mean"], COUNT: ["bodies"]}
"""The lines of each plot of a frame loop."""
FRAME_LOOP = "tamias2d.FrameLoop"
"""Marks the recording of a frame loop, which has no header."""
HEADER, SAMPLE = "tamias2d.Recording", "tamias2d.Sample"
STATE, STILL, IMPACT = "tamias2d.State", "tamias2d.Still", "tamias2d.Impact"
JOINT_EVENT, CONTACTS = "tamias2d.JointEvent", "tamias2d.Contacts"
"""Groups of components that hold the exact history, float64: `State` of what can move, at each
sample, and `Still` of what cannot, once."""

TIME, STEP = "sim_time", "step"


def speed_path(name: str) -> str:
    """The plot of a body's speed; a name may hold spaces and slashes."""
    return str(rr.new_entity_path([*SPEED.split("/")[1:], name]))


_Shown: TypeAlias = rrb.View | rrb.Container


def blueprint(run: RunData, view: View, *, timeline: str) -> rrb.Blueprint:
    """Return what the viewer shows at once: the world at the left, plots and text at the right."""
    plots: list[_Shown] = [
        _plot("Energy, J", ENERGY),
        _plot("Speed, m/s", SPEED),
        rrb.Tabs(
            _plot("Momentum, kg m/s", MOMENTUM),
            _plot("Angular momentum, kg m²/s", SPIN),
            active_tab=0,
        ),
    ]
    texts = [
        rrb.TextDocumentView(origin=ABOUT, name="About"),
        rrb.TextLogView(origin=IMPACT_LOG, name="Impacts"),
        rrb.TextDocumentView(origin=MODELS, name="Models"),
        rrb.TextDocumentView(origin=SCENE, name="Scene"),
    ]
    world = _world(view, run.scene.name, {IMPACTS: _impacts_shown(run)})
    return _window(world, texts, plots, timeline=timeline)


def frame_blueprint(view: View, name: str) -> rrb.Blueprint:
    """Return likewise what the viewer shows of a frame loop."""
    plots = [
        _plot("Kinetic energy, J", ENERGY),
        _plot("Speed, m/s", SPEED),
        _plot("Bodies", COUNT),
    ]
    texts = [
        rrb.TextDocumentView(origin=ABOUT, name="About"),
        rrb.TextLogView(origin=JOINT_LOG, name="Joints"),
    ]
    return _window(_world(view, name, {}), texts, plots, timeline=TIME)


def _window(
    world: rrb.Spatial2DView,
    texts: Sequence[rrb.View],
    plots: Sequence[_Shown],
    *,
    timeline: str,
) -> rrb.Blueprint:
    below = rrb.Tabs(*texts, active_tab=0)
    left = rrb.Vertical(world, below, row_shares=[5, 2])
    return rrb.Blueprint(
        rrb.Horizontal(left, rrb.Vertical(*plots), column_shares=[5, 3]),
        rrb.TimePanel(timeline=timeline, state="collapsed", play_state="paused", loop_mode="all"),
        rrb.BlueprintPanel(state="collapsed"),
        rrb.SelectionPanel(state="collapsed"),
        auto_layout=False,
        auto_views=False,
    )


def _world(view: View, name: str, shown: dict[EntityPath | str, Any]) -> rrb.Spatial2DView:
    """The world; its bounds are those of the picture, in which y points down."""
    (x, y), (width, height) = view.center, view.half
    return rrb.Spatial2DView(
        origin="/",  # the flip of /world has no effect in a view whose origin it is
        contents=[f"{WORLD}/**"],
        name=f"{name or 'World'}, m",
        background=(22, 24, 29),
        visual_bounds=rrb.VisualBounds2D(
            x_range=[x - width, x + width], y_range=[-y - height, -y + height]
        ),
        overrides=shown,
    )


def _impacts_shown(run: RunData) -> rrb.VisibleTimeRanges:
    memory = rrb.TimeRangeBoundary.cursor_relative(seconds=-_memory(run))
    now = rrb.TimeRangeBoundary.cursor_relative()
    return rrb.VisibleTimeRanges(timeline=TIME, start=memory, end=now)


def _memory(run: RunData) -> float:
    """For how long an impact is shown, s: of many, on average one for each body at a time."""
    moving = sum(body.dynamic for body in run.scene.bodies)
    return run.duration * min(1 / 20, moving / max(len(run.impacts), 1))


def _plot(name: str, origin: str) -> rrb.TimeSeriesView:
    return rrb.TimeSeriesView(
        origin=origin, name=name, plot_legend=rrb.PlotLegend(rrb.Corner2D.RightTop)
    )
