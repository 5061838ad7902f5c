"""The `tamias2d` command: what may be typed, and its exit codes (0 good, 1 failed, 2 bad input).

What a command does is in `tamias2d.commands`, which is imported only when a command is called, so
that `--help` comes at once.
"""

import sys
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from tamias2d.errors import TamiasError
from tamias2d.method_names import METHOD_NAMES

INTERRUPTED = 130  # as shells report a program that ended by Ctrl-C
UNREAD = 141  # likewise one that ended since nobody reads what it prints


class _Commands(TyperGroup):
    """Turns each fault of a user into one line on standard error."""

    def invoke(self, ctx: Any) -> Any:
        """Run the command that was asked for; no fault of a user ends in a traceback."""
        from tamias2d.commands.output import flush
        from tamias2d.commands.step_warnings import as_lines

        try:
            try:
                with as_lines():
                    return super().invoke(ctx)
            finally:
                flush()
        except TamiasError as fault:
            _stop(str(fault), 2)
        except BrokenPipeError:  # whoever reads has enough
            raise typer.Exit(UNREAD) from None
        except OSError as fault:
            if fault.filename is None:
                raise
            _stop(f"{fault.filename}: {fault.strerror}. Choose a place that can be used.", 2)
        except KeyboardInterrupt as stop:
            said = str(stop) or "Interrupted."
            if ctx.invoked_subcommand == "verify":
                from tamias2d.storage import results_path

                said += f" Results of earlier checks are in {results_path()}."
            _stop(said, INTERRUPTED)


def _stop(message: str, code: int) -> None:
    print(message, file=sys.stderr)
    raise typer.Exit(code)


app = typer.Typer(
    cls=_Commands,
    help="2D rigid-body physics, generated from its specification; every run says how wrong it is.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)


def _print_version(asked: bool) -> None:
    if asked:
        from tamias2d import __version__

        print(f"tamias2d {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool,
        typer.Option(
            "--version",
            metavar="",
            callback=_print_version,
            is_eager=True,
            help="Print the version.",
        ),
    ] = False,
) -> None: ...


def _method(text: str) -> str:
    """Read the name of a method as it is typed here, or as Python has it."""
    from tamias2d.suggestions import nearest

    names = {name.replace("-", ""): name for name in METHOD_NAMES}
    plain = text.lower().replace("-", "").replace("_", "").removesuffix("()")
    if plain in names:
        return names[plain]
    near = nearest(text.partition("(")[0], METHOD_NAMES)
    hint = f"Did you mean {near}?" if near else "Choose one of them."
    # a `ValueError`, as `InputError` is one, would be told by Typer without its text
    raise TamiasError(f"--method: {text!r}: must be one of {', '.join(METHOD_NAMES)} (R5). {hint}")


_Scene = Annotated[
    str, typer.Argument(metavar="SCENE", help="A name of the catalogue, or a YAML file.")
]
_Duration = Annotated[
    str | None, typer.Option(metavar="TIME", help="'4 s' or 4; else the scene's own.")
]
_TimeStep = Annotated[
    str | None, typer.Option(metavar="TIME", help="Of a stepped method: '1 ms' or 0.001.")
]
_Tolerance = Annotated[
    str | None, typer.Option(metavar="ERROR", help="As for `run`, in each world.")
]
_Vary = Annotated[
    list[str],
    typer.Option(
        metavar="PLACE=FORM",
        help="Such as 'bodies.ball.restitution=uniform(0.2, 0.8)', normal(MEAN, DEVIATION), "
        "grid(A, B, ...) or A, B, ... Repeat it for more.",
    ),
]
_Worlds = Annotated[
    int | None, typer.Option(metavar="COUNT", min=1, help="Else as the values given say.")
]
_Out = Annotated[
    Path | None,
    typer.Option(metavar="PATH", help="A Zarr store; called again, it goes on where it was."),
]
_Plot = Annotated[
    Path | None, typer.Option(metavar="PATH", help="Draw the spread: .png, .svg or .pdf.")
]
_Workers = Annotated[
    int | None, typer.Option(metavar="COUNT", min=1, help="Processes; else one a core.")
]
_Scheduler = Annotated[
    str | None, typer.Option(metavar="ADDRESS", help="Of a running Dask cluster.")
]
_World = Annotated[
    int | None, typer.Option(metavar="NUMBER", help="Simulate this world alone, to --record.")
]
_WorldRecord = Annotated[
    Path | None, typer.Option(metavar="PATH", help="Where --world goes: .rrd or .npz.")
]
_Json = Annotated[bool, typer.Option("--json", metavar="", help="Print JSON and nothing else.")]


@app.command()
def run(
    scene: _Scene,
    duration: _Duration = None,
    method: Annotated[
        str | None,
        typer.Option(
            metavar="METHOD",
            parser=_method,
            help=f"{', '.join(METHOD_NAMES)}; else closed-form where loads are constant.",
        ),
    ] = None,
    time_step: _TimeStep = None,
    tolerance: Annotated[
        str | None,
        typer.Option(metavar="ERROR", help="Such as 1e-6: the cheapest method and step within it."),
    ] = None,
    quality: Annotated[
        str | None,
        typer.Option(
            metavar="SHARE", help="Such as 0.01: overlap and energy from nothing, in piles too."
        ),
    ] = None,
    certify: Annotated[
        bool,
        typer.Option("--certify", metavar="", help="Bound the error, which takes a few runs more."),
    ] = False,
    record: Annotated[
        Path | None, typer.Option(metavar="PATH", help="Save the run: .rrd to look at, or .npz.")
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(metavar="PATH", help="Draw the run: .png, .svg or .pdf; .gif moves."),
    ] = None,
    as_json: _Json = False,
) -> None:
    """Simulate a scene; print its answer, and its error where the exact one is known."""
    from tamias2d.commands.run import run_scene

    run_scene(
        scene,
        duration=duration,
        method=method,
        time_step=time_step,
        tolerance=tolerance,
        quality=quality,
        certified=certify,
        record=record,
        plot=plot,
        as_json=as_json,
    )


@app.command()
def ensemble(
    scene: _Scene,
    *,
    vary: _Vary,
    worlds: _Worlds = None,
    seed: Annotated[int, typer.Option(min=0, help="Of what is drawn.")] = 0,
    duration: _Duration = None,
    method: Annotated[
        str | None, typer.Option(metavar="METHOD", parser=_method, help="As for `run`.")
    ] = None,
    time_step: _TimeStep = None,
    tolerance: _Tolerance = None,
    out: _Out = None,
    plot: _Plot = None,
    workers: _Workers = None,
    scheduler: _Scheduler = None,
    world: _World = None,
    record: _WorldRecord = None,
    as_json: _Json = False,
) -> None:
    """Simulate a scene in many worlds that differ as --vary says, and print how they spread."""
    from tamias2d.commands.ensemble import record_world, run_ensemble

    asked: dict[str, Any] = {
        "vary": vary,
        "worlds": worlds,
        "seed": seed,
        "duration": duration,
        "method": method,
        "time_step": time_step,
        "tolerance": tolerance,
    }
    if world is not None or record is not None:
        record_world(scene, world, record, **asked)
        return
    where: dict[str, Any] = {"out": out, "plot": plot, "workers": workers, "scheduler": scheduler}
    run_ensemble(scene, **where, **asked, as_json=as_json)


@app.command()
def recommend(
    scene: _Scene,
    tolerance: Annotated[
        str,
        typer.Option(
            metavar="ERROR", help="Of places, relative to how far the farthest body goes."
        ),
    ],
    duration: _Duration = None,
    as_json: _Json = False,
) -> None:
    """Say which method and step meet a tolerance at the least cost, and why others lost."""
    from tamias2d.commands.recommend import recommend_method

    recommend_method(scene, tolerance=tolerance, duration=duration, as_json=as_json)


@app.command()
def scenes(as_json: _Json = False) -> None:
    """List the scenes of the catalogue."""
    from tamias2d.commands.scenes import list_scenes

    list_scenes(as_json=as_json)


@app.command()
def explain(
    scene: _Scene,
    source: Annotated[
        bool,
        typer.Option(
            "--source", metavar="", help="Print the code that is made for exactly this scene."
        ),
    ] = False,
    method: Annotated[
        str,
        typer.Option(
            metavar="METHOD", parser=_method, help="The stepped method that the code is made for."
        ),
    ] = "velocity-verlet",
    duration: _Duration = None,
    as_json: _Json = False,
) -> None:
    """Say which models, states and terms a scene needs, and why the others are left out."""
    from tamias2d.commands.explain import explain_scene, explain_source

    if source:
        explain_source(scene, method)
    else:
        explain_scene(scene, duration=duration, as_json=as_json)


@app.command()
def verify(
    ids: Annotated[
        list[str] | None, typer.Argument(metavar="[ID]...", help="Cases, such as TC1; else all.")
    ] = None,
    as_json: _Json = False,
) -> None:
    """Compare the cases of the specification with their exact answers."""
    from tamias2d.commands.verify import verify_cases

    raise typer.Exit(verify_cases(ids or [], as_json=as_json))


@app.command()
def trace(
    item: Annotated[
        str | None, typer.Argument(metavar="[ID]", help="An item, such as A6; else all.")
    ] = None,
    as_json: _Json = False,
) -> None:
    """Follow requirements to models, code, cases and their last results."""
    from tamias2d.commands.trace import trace_items

    raise typer.Exit(trace_items(item, as_json=as_json))


@app.command()
def replay(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A recording, .rrd or .npz.")],
    check: Annotated[
        bool,
        typer.Option(
            "--check",
            metavar="",
            help="Compute the run again, and compare every bit of its numbers, not what is drawn.",
        ),
    ] = False,
) -> None:
    """Open a recording in the viewer, or check that it can be computed again."""
    from tamias2d.commands.replay import replay_file

    raise typer.Exit(replay_file(file, check=check))


@app.command()
def warm() -> None:
    """Compile ahead what runs would otherwise wait for; it is kept for later ones."""
    from tamias2d.commands.warm import warm_up

    warm_up()


@app.command()
def tradeoff(
    scene: _Scene,
    duration: _Duration = None,
    tolerance: Annotated[
        float | None, typer.Option(metavar="ERROR", help="Relative, such as 1e-6: who is within?")
    ] = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="PATH", help="Draw it: .png, .svg or .pdf.")
    ] = None,
    phases: Annotated[
        int, typer.Option(metavar="COUNT", min=1, help="Starts of a scene with impacts, at most.")
    ] = 32,
    as_json: _Json = False,
) -> None:
    """Measure what accuracy costs on a scene: each method, its errors, its work, its seconds.

    It takes up to about two minutes of the processor. Ctrl-C ends it and shows what there is.
    """
    from tamias2d.commands.tradeoff import show_tradeoff

    complete = show_tradeoff(
        scene,
        duration=duration,
        tolerance=tolerance,
        plot=plot,
        phases=phases,
        as_json=as_json,
    )
    if not complete:
        raise typer.Exit(INTERRUPTED)


def main() -> None:
    """Run the command line of this process."""
    from tamias2d.commands.output import command, prepare

    prepare()
    app(prog_name=command())
