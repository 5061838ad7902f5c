"""What the page of an item consists of, as Markdown.

Serves: the directives of items and symbols. Hides: wording and order of an item's parts.
"""

from collections.abc import Iterator

from tamias2d.spec.chapter import Item
from tamias2d.spec.implication import POINTS
from tamias2d.spec.symbols import Index, Symbol
from tamias2d.spec.tex import unit_tex
from weave import cases, schemes
from weave.formulas import equation, named, rate, relation, stack
from weave.links import ids, linked
from weave.markdown import bullets, code, display, fence, table
from weave.woven import Woven

_DOCUMENTS = {
    "SRS": "SRS of 2018",
    "Drasil": "specification by Drasil",
    "plan": "verification plan",
    "code": "program",
    "report": "reports",
}


def body(item: Item, woven: Woven) -> str:
    """All parts of an item, in reading order."""
    parts = [
        *_statement(item, woven),
        *_formulas(item, woven),
        *_conditions(item, woven),
        *_symbols(item, woven),
        *_derivation(item, woven),
        *schemes.parts(item),
        *cases.parts(item, woven),
        *_code(item, woven),
        *_relations(item, woven),
    ]
    return "\n".join(parts)


def _statement(item: Item, woven: Woven) -> Iterator[str]:
    if document := item.data.get("document"):
        yield f"*In the {_DOCUMENTS.get(document, document)}*\n"
    for key, lead in (
        ("says", ""),
        ("because", "*Why:* "),
        ("found", "*Found:* "),
        ("now", "*Now:* "),
        ("fit", "*Fit criterion:* "),
    ):
        if text := item.data.get(key):
            text = linked(text, woven)
            yield f"{lead}{text if lead else _capital(text)}{_stop(text)}\n"


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def _stop(text: str) -> str:
    return "" if text.rstrip()[-1:] in ".:!?" else "."


def _formulas(item: Item, woven: Woven) -> Iterator[str]:
    data = item.data
    lines = [relation(woven, data["equation"])] if "equation" in data else []
    lines += [rate(woven, state, text) for state, text in data.get("states", {}).items()]
    lines += [equation(woven, name, text) for name, text in data.get("equations", {}).items()]
    if item.kind == "constraint":
        lines += [relation(woven, f"{text} == 0") for text in data["constraint"]]
    if lines and item.kind != "case":
        yield display(stack(lines))
    if closed := data.get("closed_form"):
        when = linked(closed.get("when", ""), woven)
        yield f"**In closed form**, when {when}:\n"
        lines = [equation(woven, name, text) for name, text in closed.items() if name != "when"]
        yield display(stack(lines))


def _conditions(item: Item, woven: Woven) -> Iterator[str]:
    if text := item.data.get("condition"):
        yield f"*Holds while* {linked(text, woven)}.\n"
    if text := item.data.get("unchecked"):
        yield f"*Nothing checks this statement*: {linked(text, woven)}.\n"
    if item.kind == "model":
        for key, lead in (("input", "Given"), ("output", "Find")):
            names = ", ".join(f"${woven.letter(name)}$" for name in item.data[key])
            yield f"**{lead}** {names}.\n"


def _symbols(item: Item, woven: Woven) -> Iterator[str]:
    names = named(item)
    if names and item.kind in ("theory", "definition", "model", "property", "constraint"):
        yield fence("dropdown", "Symbols", symbol_table(names, woven), depth=6, color="light")


def symbol_table(names: list[str], woven: Woven) -> str:
    """Letter, name, meaning, unit and admissible values of some names."""
    rows = [_symbol_row(name, woven) for name in names if _is_known(name, woven)]
    return table(["", "name", "meaning", "unit", "admissible"], rows, style="symbols")


def _is_known(name: str, woven: Woven) -> bool:
    from tamias2d.spec.messages import SpecFault

    try:
        woven.spec.table.resolve(name)
    except SpecFault:
        return False
    return True


def _symbol_row(name: str, woven: Woven) -> list[str]:
    reference = woven.spec.table.resolve(name)
    symbol = reference.symbol
    meaning = linked(symbol.says, woven) + "".join(_index_words(i) for i in reference.indices)
    typical = f"; typically {symbol.typical}" if symbol.typical else ""
    letter, word = f"${woven.letter(name)}$", f"{{symbol}}`{name}`"
    return [letter, word, f"{meaning}{typical}", _unit(symbol.unit), _admissible(symbol)]


def _unit(text: str) -> str:
    return "" if text == "1" else rf"$\mathrm{{{unit_tex(text)}}}$"


def _index_words(index: Index) -> str:
    return f", {index.says}"


def _admissible(symbol: Symbol) -> str:
    text = symbol.range.text
    signs = text.replace(">=", r"\ge").replace("<=", r"\le").replace("*pi", r"\pi")
    return f"${signs}$" if text else ("vector" if symbol.shape == "vector" else "any")


def index_table(woven: Woven) -> str:
    """The indices that a name may take."""
    indices = woven.spec.table.indices.values()
    rows = [
        [f"$x{'^' if i.place == 'super' else '_'}{{{i.tex}}}$", f"`{i.name}`", i.says]
        for i in indices
    ]
    return table(["", "name", "meaning"], rows, style="symbols")


def _derivation(item: Item, woven: Woven) -> Iterator[str]:
    steps = item.data.get("derivation", [])
    if not steps:
        return
    lines = [_step(number, step, woven) for number, step in enumerate(steps, 1)]
    note = (
        "Each step was checked to follow from the one before, numerically "
        f"at {POINTS} random points of the symbols' ranges, when this page was built."
    )
    yield fence(
        "dropdown",
        "Derivation",
        "\n".join([*lines, f"\n*{note}*"]),
        depth=6,
        color="light",
        open="",
    )


def _step(number: int, step: dict[str, str], woven: Woven) -> str:
    formula = display(stack([relation(woven, step["equation"])]))
    return f"{number}. {_capital(linked(step['by'], woven))}:\n\n{_indented(formula)}"


def _indented(text: str) -> str:
    return "".join(f"   {line}\n" for line in text.splitlines())


def _code(item: Item, woven: Woven) -> Iterator[str]:
    functions = woven.code(item.id)
    if not functions:
        return
    printed = "\n".join(
        fence("literalinclude", f"/../{file}", "", language="python", pyobject=function)
        for function, file in functions
    )
    tabs = fence("tab-item", f"Printed into {functions[0][1]}", printed, depth=5)
    tabs += fence("tab-item", f"Written in {item.file}", code("yaml", woven.source(item)), depth=5)
    sides = fence("tab-set", "", tabs, depth=6)
    yield fence("dropdown", "Generated code", sides, depth=7, color="light")


def _relations(item: Item, woven: Woven) -> Iterator[str]:
    data = item.data
    used_by = woven.used_by.get(item.id, [])  # cases stand in a table of their own
    rows = [
        ("uses", data.get("uses", [])),
        ("verifies", data.get("verifies", [])),
        ("affects", data.get("affects", [])),
        ("corrects", [id for id in data.get("corrects", []) if id != "none"]),
        ("used by", [id for id in used_by if woven.spec.items[id].kind != "case"]),
        ("corrected by", woven.corrected_by.get(item.id, [])),
    ]
    lines = [f"{lead} {ids(names)}" for lead, names in rows if names]
    if sources := data.get("source", []):
        keys = sources if isinstance(sources, list) else []
        lines += ["sources " + ", ".join(f"{{cite}}`{key}`" for key in keys)] if keys else []
    place = f"`{item.file}:{item.line}`"
    label = data.get("label_2018")
    lines.append(f"{place}, 2018: {label}" if label else place)
    yield fence("container", "srs-relations", bullets(lines), depth=4)
