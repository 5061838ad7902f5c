"""The pages of verification results and of the survey.

Serves: `{published-tables}`, `{all-results}`, `{survey}`. Hides: how cases are summed up.
"""

from docutils import nodes

from weave import published
from weave.cases import NO_RESULTS, row
from weave.chapter import WovenDirective
from weave.links import rank
from weave.markdown import table


class PublishedDirective(WovenDirective):
    """How the tables of 2018 are reproduced."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container()
        cases = (i.id for i in self.woven.spec.of_kind("case") if "published" in i.data)
        self.parse(published.summary(sorted(cases, key=rank)), box)
        return [box]


class ResultsDirective(WovenDirective):
    """Every comparison of the last run of the cases."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container()
        outcomes = self.woven.outcomes
        rows = [
            [f"{{srs}}`{id}`", *row(outcome)]
            for id in sorted(self.woven.spec.items.keys() & outcomes, key=rank)
            for outcome in outcomes[id]
        ]
        head = ["case", "compared", "error", "tolerance", "verdict"]
        self.parse(table(head, rows, style="results") if rows else NO_RESULTS, box)
        return [box]


class SurveyDirective(WovenDirective):
    """Task, questions and number of answers of each case that is a survey."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container()
        for item in self.woven.spec.of_kind("case"):
            if survey := item.data.get("survey"):
                questions = "\n".join(f"1. {' '.join(q.split())}" for q in survey["questions"])
                task = (
                    f"The task: {survey.get('task', '')}, within {survey.get('limit', 'any time')}."
                )
                answers = f"Answers so far: **{survey['answers']}** ({{srs}}`{item.id}`)."
                self.parse(f"{task}\n\n{questions}\n\n{answers}", box)
        return [box]
