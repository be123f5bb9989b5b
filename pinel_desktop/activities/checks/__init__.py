"""The table of all kinds of checks, in the order of the teacher's form.

Each kind has a file in the folders below: its model, its evaluation, its texts for pupils, its fields in the form.
The model's docstring is the kind's row in docs/activities.md. The texts are in
`messages/catalogue/LANGUAGE/activities.json`, the form's labels in `page/teacher.json` beside it.
"""

from typing import Annotated, get_args

from pydantic import Field

from pinel_desktop.activities.checks.base import CheckBase
from pinel_desktop.activities.checks.floor import (
    closed,
    draws,
    mark_count,
    marks,
    pushed,
    symmetric,
)
from pinel_desktop.activities.checks.movement import (
    avoids,
    ends_at,
    ends_heading,
    ends_in,
    path_length,
    touches_nothing,
    turned_total,
    visits,
)
from pinel_desktop.activities.checks.program import block_count, executed, nesting, uses
from pinel_desktop.activities.checks.run import any_of, finished, says, sign_shown, time

Check = Annotated[
    finished.Finished
    | ends_in.EndsIn
    | ends_at.EndsAt
    | ends_heading.EndsHeading
    | visits.Visits
    | avoids.Avoids
    | touches_nothing.TouchesNothing
    | pushed.Pushed
    | draws.Draws
    | closed.Closed
    | symmetric.Symmetric
    | turned_total.TurnedTotal
    | path_length.PathLength
    | block_count.BlockCount
    | nesting.Nesting
    | uses.Uses
    | executed.Executed
    | time.Time
    | says.ShowsText
    | sign_shown.SignShown
    | marks.Marks
    | mark_count.MarkCount
    | any_of.AnyOf,
    Field(discriminator="check"),
]

any_of.AnyOf.model_rebuild(_types_namespace={"Check": Check})

KINDS: dict[str, type[CheckBase]] = {
    get_args(kind.model_fields["check"].annotation)[0]: kind
    for kind in get_args(get_args(Check)[0])
}
