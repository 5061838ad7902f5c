"""Every error that a user of the library can meet.

Each message is complete in one line: *where: what was found: which rule (its id). What to do.*
"""


def path_text(path: object) -> str:
    """Return a path as a message has it: on one line, without what cannot be printed."""
    text = str(path)
    return text if text.isprintable() else repr(text)


def printable(message: str) -> str:
    """Return a message with what cannot be seen in it, such as U+200B, written as an escape."""
    if message.isprintable():
        return message
    letters = (
        letter if letter.isprintable() else letter.encode("unicode_escape").decode()
        for letter in message
    )
    return "".join(letters)


class TamiasError(Exception):
    """The base of all errors that this library raises on purpose."""


class InputError(TamiasError, ValueError):
    """An argument breaks a rule of the specification (R4)."""


class ArgumentError(InputError, TypeError):
    """A call lacks an argument, or has one that the function does not take."""


class SpecError(TamiasError):
    """A chapter of the specification is at fault."""


class SceneError(TamiasError, ValueError):
    """A scene is at fault (R2, R3, R4)."""


class RecordingError(TamiasError):
    """A recording cannot be written, read or recomputed."""


class FrameLoopError(RecordingError):
    """A recording is one of a frame loop, to be looked at: no run can be made of it."""


class MissingExtraError(RecordingError):
    """A library is missing that an extra of the package brings."""

    def __init__(self, message: str, *, extra: str) -> None:
        super().__init__(message)
        self.extra = extra


class StepWarning(UserWarning):
    """A time step is too long for what acts: the answer is not what it should be (DD54, IM10)."""


class SimulationError(TamiasError):
    """A run is refused, because the model has no unique or no computable answer."""

    run: object = None
    """The run up to there, if it had begun."""
