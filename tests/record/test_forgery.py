"""What a check says of a certificate rests on a computation, and files hold what they claim."""

import io
import json
import zipfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d import archive, record, replay
from tamias2d.record import header as headers, history


@pytest.fixture(scope="module")
def certified() -> t2.Run:
    return t2.simulate(t2.catalogue.load("pendulum"), duration=1.0, tolerance=1e-4)


def forged(path: Path, change: Callable[[dict[str, Any]], None], *, sealed: bool) -> Path:
    """Change the header of an `.npz`; `sealed`, with a digest that fits."""
    stored = dict(np.load(path))
    values = json.loads(str(stored.pop("header")))
    change(values)
    header = headers.loads(json.dumps(values), where="")
    if sealed:
        run = history.run_of(header, stored, where="")
        header = replace(header, digest=headers.digest(header, run))
    np.savez(path, header=np.array(header.dumps()), **stored)
    return path


@pytest.mark.parametrize("suffix", [".npz", ".rrd"])
def test_an_honest_certificate_is_computed_again(
    certified: t2.Run, tmp_path: Path, suffix: str
) -> None:
    path = tmp_path / f"run{suffix}"
    certified.save(path)
    answer = replay.check(path)
    assert answer.identical
    assert "its certificate, computed again, is the same" in answer.says


CLAIMS: dict[str, Callable[[dict[str, Any]], None]] = {
    "bound": lambda values: values["certificate"].update(bound=1e-300),
    "kind": lambda values: values["certificate"].update(kind="exact"),
    "how": lambda values: values["certificate"].update(how="by thinking hard"),
    "claims": lambda values: values["certificate"].update(claims=["everything"]),
    "does_not_claim": lambda values: values["certificate"].update(does_not_claim=[]),
}


@pytest.mark.parametrize("name", CLAIMS)
def test_a_forged_certificate_is_found_though_its_digest_fits(
    certified: t2.Run, tmp_path: Path, name: str
) -> None:
    path = tmp_path / "run.npz"
    certified.save(path)
    answer = replay.check(forged(path, CLAIMS[name], sealed=True))
    assert not answer.identical
    assert f"its certificate differs: {name}: recorded" in answer.says


def test_a_certificate_that_was_put_there_is_found(certified: t2.Run, tmp_path: Path) -> None:
    """Of a run that has none, and whose own is another one."""
    path = tmp_path / "run.npz"
    t2.simulate(certified.scene, duration=1.0, method=t2.ExplicitEuler(), time_step=0.01).save(path)
    assert certified.certificate is not None
    claim = certified.certificate.as_json()
    answer = replay.check(
        forged(path, lambda values: values.update(certificate=claim), sealed=True)
    )
    assert "its certificate differs" in answer.says


CHANGES: dict[str, Callable[[dict[str, Any]], None]] = {
    "notes": lambda values: values.update(notes=["verified by a court"]),
    "versions": lambda values: values["versions"].update(numpy="9.9"),
    "bound": CLAIMS["bound"],
}


@pytest.mark.parametrize("name", CHANGES)
def test_the_digest_covers_the_header(certified: t2.Run, tmp_path: Path, name: str) -> None:
    path = tmp_path / "run.npz"
    certified.save(path)
    forged(path, CHANGES[name], sealed=False)
    assert not replay.check(path).identical
    assert "it was changed after it was recorded" in replay.check(path).says
    with pytest.raises(t2.RecordingError, match="was changed after it was recorded"):
        record.load(path)


def test_a_header_that_nests_without_end(certified: t2.Run, tmp_path: Path) -> None:
    path = tmp_path / "run.npz"
    certified.save(path)
    stored = dict(np.load(path))
    np.savez(path, **{**stored, "header": np.array("[" * 200_000)})
    with pytest.raises(t2.RecordingError, match="its header cannot be read"):
        record.load(path)


def npz(path: Path, members: dict[str, bytes], compression: int = zipfile.ZIP_STORED) -> Path:
    with zipfile.ZipFile(path, "w", compression) as container:
        for name, content in members.items():
            container.writestr(name, content)
    return path


def npy(array: np.ndarray[Any, Any]) -> bytes:
    file = io.BytesIO()
    np.save(file, array)
    return file.getvalue()


def refusal(path: Path) -> str:
    with pytest.raises(t2.RecordingError) as caught:
        archive.read(path, remedy="Save it again.")
    assert str(caught.value).startswith(f"{path}: ")
    assert str(caught.value).endswith(" Save it again.")
    return str(caught.value)


def test_what_would_inflate_is_refused_before_it_is_read(tmp_path: Path) -> None:
    content = npy(np.zeros(1_000_000))
    path = npz(tmp_path / "bomb.npz", {"times.npy": content}, zipfile.ZIP_DEFLATED)
    assert path.stat().st_size < 20_000
    assert "times.npy: is compressed" in refusal(path)


def test_a_directory_that_claims_more_than_there_is(tmp_path: Path) -> None:
    """Many entries that lead to the same bytes."""
    path = tmp_path / "overlapping.npz"
    content = npy(np.zeros(10_000))
    with zipfile.ZipFile(path, "w") as container:
        container.writestr("a.npy", content)
        (entry,) = container.infolist()
        for k in range(50):
            twin = zipfile.ZipInfo(f"b{k}.npy")
            twin.header_offset, twin.CRC = entry.header_offset, entry.CRC
            twin.compress_size = twin.file_size = entry.file_size
            container.filelist.append(twin)
            container.NameToInfo[twin.filename] = twin
    assert "bytes of arrays in" in refusal(path)


@pytest.mark.parametrize("shape", ["(1000000000000,)", "(3, 0)", "(2,)", "(4,)", "(-1,)"])
def test_an_array_that_claims_another_size_than_it_has(tmp_path: Path, shape: str) -> None:
    content = npy(np.zeros(3)).replace(b"(3,), }".ljust(40), f"{shape}, }}".encode().ljust(40))
    assert shape.encode() in content
    refusal(npz(tmp_path / "array.npz", {"a.npy": content}))


@pytest.mark.filterwarnings("ignore:Duplicate name")
def test_two_arrays_of_one_name(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "two.npz", "w") as container:
        for _ in range(2):
            container.writestr("a.npy", npy(np.zeros(3)))
    assert "two arrays of one name" in refusal(tmp_path / "two.npz")


def test_arrays_are_read_as_they_were_written(tmp_path: Path) -> None:
    arrays = {"a": np.arange(6.0).reshape(2, 3), "b": np.array("text"), "c": np.zeros((0, 2))}
    arrays["f"] = np.asfortranarray(arrays["a"])
    np.savez(tmp_path / "arrays.npz", **arrays)
    found = archive.read(tmp_path / "arrays.npz", remedy="")
    assert set(found) == set(arrays)
    for name, array in arrays.items():
        assert np.array_equal(found[name], array)
        assert found[name].dtype == array.dtype
