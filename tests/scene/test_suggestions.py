"""A call with wrong arguments says what was meant; names of other engines lead to ours."""

import copy
import pickle
import sys
from collections.abc import Callable

import pytest

import tamias2d as t2
from tamias2d.attribute_suggestions import suggests_attributes
from tamias2d.suggestions import nearest, suggests

DISC = t2.Disc(radius=0.5)
EMPTY = t2.Scene(gravity=(0.0, 0.0))
BODY = {"mass": 1.0, "position": (0.0, 0.0)}


def scene() -> t2.Scene:
    return t2.Scene(gravity=(0, 0))


WRONG: list[tuple[Callable[[], object], str]] = [
    (
        lambda: scene().add_body(DISC, **BODY, resitution=0.5),
        "add_body(): unknown argument 'resitution'; did you mean 'restitution'?",
    ),
    (
        lambda: scene().add_body(DISC, 1, (0, 0)),
        "add_body(Disc(radius=0.5), 1, (0, 0)): arguments have names; write "
        "add_body(Disc(radius=0.5), mass=1, position=(0, 0)).",
    ),
    (
        lambda: scene().add_body(DISC, mass=1),
        "add_body(): argument 'position' is missing; add position=...",
    ),
    (
        lambda: scene().add_body(DISC, **BODY, elasticity=1),
        "add_body(): unknown argument 'elasticity'; did you mean 'restitution'?",
    ),
    (
        lambda: scene().add_static(DISC, shape=DISC),
        "add_static(): multiple values for argument 'shape'.",
    ),
    (
        lambda: scene().set_restitution("a", "b", restitution=1),
        "set_restitution(): unknown argument 'restitution'; it takes first, second, value.",
    ),
    (lambda: t2.Disc(0.5), "Disc(0.5): arguments have names; write Disc(radius=0.5)."),
    (lambda: t2.Disc(raduis=1), "Disc(): unknown argument 'raduis'; did you mean 'radius'?"),
    (lambda: t2.Disc(), "Disc(): argument 'radius' is missing; add radius=..."),
    (lambda: t2.Box(1, 2), "Box(1, 2): arguments have names; write Box(width=1, height=2)."),
    (lambda: t2.Box(1, width=2), "Box(1, ...): arguments have names; write Box(height=1, ...)."),
    (
        lambda: t2.Box(1, 2, 3),
        "Box(): found 3 arguments without a name; it takes width, height.",
    ),
    (
        lambda: t2.Polygon([(0, 0), (1, 0), (0, 1)]),
        "Polygon([(0, 0), (1, 0), (0, 1)]): arguments have names; write "
        "Polygon(vertices=[(0, 0), (1, 0), (0, 1)]).",
    ),
    (lambda: t2.Part(DISC), "Part(Disc(radius=0.5)): arguments have names; write Part(shape="),
    (lambda: t2.Compound([]), "Compound([]): arguments have names; write Compound(parts=[])."),
    (lambda: t2.Scene((0, 0)), "Scene((0, 0)): arguments have names; write Scene(gravity=(0, 0))."),
    (lambda: t2.simulate(scene(), 4), "simulate(..., 4): arguments have names; write simulate(..."),
    (lambda: t2.simulate(scene(), dt=1), "simulate(): unknown argument 'dt'; did you mean 'time_s"),
    (lambda: t2.Simulator(scene(), dt=1), "Simulator(): unknown argument 'dt'; did you mean 'time"),
    (
        lambda: t2.Simulator(EMPTY, compiled=False).add(DISC, mass=1, pos=(0, 0)),
        "add(): unknown argument 'pos'; did you mean 'position'?",
    ),
    (
        lambda: t2.Stepped(substep=8),
        "Stepped(): unknown argument 'substep'; did you mean 'substeps",
    ),
    (
        lambda: t2.ExplicitEuler(0.1),
        "ExplicitEuler(): found 1 arguments without a name; it takes no",
    ),
    (
        lambda: t2.simulate(scene(), duration=0.1).plot("run.png", bodies=["ball"]),
        "plot(): unknown argument 'bodies'; it takes path.",
    ),
    (lambda: t2.Body(mass=1, moment=2), "Body(): a scene makes it; write Scene.add_body("),
    (lambda: t2.catalogue.load(), "load(): argument 'name' is missing; add name=..."),
]


@pytest.mark.parametrize(("call", "says"), WRONG, ids=[says[:30] for _, says in WRONG])
def test_a_wrong_call_says_what_was_meant(call: Callable[[], object], says: str) -> None:
    with pytest.raises(t2.ArgumentError) as refusal:
        call()
    assert str(refusal.value).startswith(says)
    assert isinstance(refusal.value, t2.InputError)
    assert isinstance(refusal.value, TypeError)  # as Python raises it


def test_an_error_from_inside_stays_what_it_is() -> None:
    @suggests
    def broken(value: int) -> None:
        raise TypeError(f"inside: {value}")

    with pytest.raises(TypeError, match="inside: 3") as error:
        broken(3)
    assert not isinstance(error.value, t2.ArgumentError)


@pytest.mark.parametrize(
    ("word", "meant"),
    [("circle", "disc"), ("Rect", "box"), ("hexagon", None), ("half_plane", "half-plane")],
)
def test_shapes_of_a_file_are_found_by_other_names(word: str, meant: str | None) -> None:
    assert nearest(word, ["disc", "box", "half-plane"]) == meant


def test_a_letter_is_missing_sooner_than_another_word_is_meant() -> None:
    """Other engines call a scene a world."""
    assert nearest("world", ["scene", "worlds"]) == "worlds"
    assert nearest("world", ["scene", "seed"]) == "scene"


def test_what_suggests_is_copied_and_pickled_as_before() -> None:
    for value in (DISC, t2.Compound(parts=[t2.Part(shape=DISC)]), t2.Stepped(substeps=8)):
        assert copy.deepcopy(value) == value == pickle.loads(pickle.dumps(value))
    assert pickle.loads(pickle.dumps(t2.simulate)) is t2.simulate


def test_the_frame_loop_is_left_alone() -> None:
    """What is called sixty times a second and more has no wrapper, and its own name."""
    assert not hasattr(t2.Simulator.step, "__wrapped__")
    with pytest.raises(TypeError, match=r"^Simulator\.step\(\) got an unexpected .* 'dt'"):
        t2.Simulator(EMPTY, compiled=False).step(dt=1 / 60)  # type: ignore[call-arg]
    assert hasattr(t2.Simulator.add, "__wrapped__")


SIM = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), compiled=False)
MISSING: list[tuple[object, str, str | None]] = [
    (SIM, "angle", "orientation"),
    (SIM, "vel", "velocity"),
    (SIM, "inertia", "body(k).inertia"),
    (SIM, "shape", "body(k).shape"),
    (EMPTY, "add_box", "add_body(Box(...), ...)"),
    (EMPTY, "add_circle", "add_body(Disc(...), ...)"),
    (EMPTY, "add_halfplane", "add_static(HalfPlane(...))"),
    (EMPTY, "gravitiy", "gravity"),
    (t2.Scene(gravity=(0.0, 0.0)), "xylophone", None),
]


@pytest.mark.parametrize(("has_not", "name", "meant"), MISSING)
def test_an_unknown_attribute_says_what_was_meant(
    has_not: object, name: str, meant: str | None
) -> None:
    with pytest.raises(AttributeError) as told:
        getattr(has_not, name)
    hint = f"; did you mean '{meant}'?" if meant else ""
    of = type(has_not).__name__
    assert str(told.value) == f"'{of}' object has no attribute '{name}'{hint}"
    assert type(told.value) is AttributeError
    assert not hasattr(has_not, name)


def test_a_body_says_so_too() -> None:
    one = scene()
    one.add_body(DISC, **BODY)
    with pytest.raises(AttributeError, match="did you mean 'angular_velocity'"):
        _ = one.bodies[0].omega  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="did you mean 'shape'"):
        _ = one.bodies[0].shapes  # type: ignore[attr-defined]


def test_private_names_and_errors_inside_properties_stay_what_they_are() -> None:
    with pytest.raises(AttributeError, match=r"has no attribute '_positions'$"):
        _ = SIM._positions  # type: ignore[attr-defined]

    @suggests_attributes()
    class Thing:
        @property
        def size(self) -> int:
            return int(self.sise)  # type: ignore[attr-defined]

    with pytest.raises(AttributeError, match="no attribute 'sise'; did you mean 'size'"):
        _ = Thing().size


def test_objects_that_suggest_can_be_copied() -> None:
    one = scene()
    one.add_body(DISC, **BODY)
    assert copy.deepcopy(one).bodies == pickle.loads(pickle.dumps(one)).bodies == one.bodies
    assert len(copy.copy(SIM)) == 0


def test_a_simulator_leaves_misspelt_attributes_to_python(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A hook for them would make each look at an attribute, and so each step, dearer."""
    assert not hasattr(t2.Simulator, "__getattr__")
    assert "mass" in dir(SIM)
    assert not {"inertia", "angle"} & set(dir(SIM))
    try:
        _ = SIM.positon  # type: ignore[attr-defined]
    except AttributeError as told:
        sys.__excepthook__(type(told), told, None)
    assert "Did you mean: 'position'?" in capsys.readouterr().err
