"""A certificate names the computation that it follows from; its words are for people alone."""

from collections.abc import Callable
from pathlib import Path

import pytest

import tamias2d as t2
from tamias2d.certificate import Basis
from tamias2d.motion import Method
from tamias2d.solve import solve, solve_halved
from tamias2d.study.certify import (
    certify_as,
    certify_embedded,
    certify_halved,
    certify_tighter,
    certify_with_error,
)
from tamias2d.study.embedded import looser_than
from tamias2d.study.path_error import error_beside

DURATION = 2.0


def by(method: Method) -> t2.Run:
    return solve(t2.catalogue.load("kepler"), duration=DURATION, method=method)


def looser() -> t2.Run:
    method = t2.Dop853(1e-8)
    return certify_tighter(by(method), by(next(looser_than(method))))


def by_error_equation() -> t2.Run:
    run = by(t2.Dop853(1e-6))
    return certify_with_error(run, error_beside(run))


def halved() -> t2.Run:
    scene = t2.catalogue.load("kepler")
    return certify_halved(*solve_halved(scene, duration=DURATION, method=t2.Dop853(1e-8)))[0]


def asked(name: str, **limits: float) -> t2.Run:
    return t2.simulate(t2.catalogue.load(name), duration=DURATION, **limits)  # type: ignore[arg-type]


CERTIFIED: dict[str, Callable[[], t2.Run]] = {
    "usual": lambda: t2.certify(asked("tc1")),
    "error equation": by_error_equation,
    "halved steps": halved,
    "companions": lambda: certify_embedded(by(t2.Dop853(1e-6)))[0],
    "looser run": looser,
    "planned steps": lambda: asked("incline", tolerance=1e-2),
    "quality": lambda: asked("cradle-touching", quality=0.01),
}


@pytest.mark.parametrize("kind", CERTIFIED)
def test_a_certificate_is_made_again_from_its_basis(kind: str) -> None:
    run = CERTIFIED[kind]()
    claimed = run.certificate
    assert claimed is not None
    assert claimed.bound is not None
    assert claimed.basis.kind == kind
    assert certify_as(run, claimed.basis).certificate == claimed


@pytest.mark.parametrize("basis", [Basis("looser run", rtol=0.5), Basis("halved steps")])
def test_a_basis_that_a_run_cannot_have_gives_the_usual_certificate(basis: Basis) -> None:
    run = by(t2.Dop853(1e-6))
    assert certify_as(run, basis).certificate == t2.certify(run).certificate


def test_what_a_rule_decided_is_told_of_a_run_that_was_read(tmp_path: Path) -> None:
    scene = t2.Scene(gravity=(0, 0))
    for place, speed in ((-2.0, 1.0), (1.0, 0.0), (2.0, 0.0)):  # the last two touch
        scene.add_body(
            t2.Disc(radius=0.5), mass=1, position=(place, 0), velocity=(speed, 0), restitution=1
        )
    run = t2.simulate(scene, duration=4.0)
    assert run.ruled is not None
    assert run.ruled in run.notes
    run.save(tmp_path / "run.npz")
    read = t2.Run.load(tmp_path / "run.npz")
    assert read.ruled == run.ruled
    certificate = t2.certify(read).certificate
    assert certificate is not None
    assert certificate == t2.certify(run).certificate
    assert f"that nature decides as the {run.ruled}" in certificate.does_not_claim


def test_why_contacts_are_stepped_is_kept(tmp_path: Path) -> None:
    run = asked("incline")
    assert run.stepped_because is not None
    assert run.notes[0].endswith(run.stepped_because)
    run.save(tmp_path / "run.npz")
    assert t2.Run.load(tmp_path / "run.npz").stepped_because == run.stepped_because
    assert by(t2.Dop853()).stepped_because is None
