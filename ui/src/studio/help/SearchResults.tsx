import { matchesAll, tokenize } from "../../blocks/toolbox/search";
import { texts } from "../../i18n";
import { valueIn } from "../../kit/requests/load_state";
import { useManuals } from "../../manuals/library";
import { ManualHits } from "../../manuals/ManualHits";
import { searchManuals } from "../../manuals/search";
import { BlockList } from "./BlockList";
import { ExampleList } from "./ExampleList";
import { useHelpContent } from "./help_content";
import { KeyList } from "./KeyList";
import { keyGroups } from "./keys";
import { TaskList } from "./TaskList";
import { TASK_NAMES } from "./tasks";

const MAX_MANUAL_HITS = 4;

/** Results of the query: blocks first, then tasks, examples and keys, and at last the manuals. */
export function SearchResults({ query }: { query: string }) {
  const { drawings, examples } = useHelpContent();
  const { help } = texts.value;
  const queryTerms = tokenize(query);
  const blocks = drawings.find(query);
  const tasks = TASK_NAMES.filter((name) => matchesAll(help.tasks[name], queryTerms));
  const shown = examples.filter(({ title, about }) => matchesAll(`${title} ${about}`, queryTerms));
  const keys = keyGroups(texts.value).flatMap(({ rows, more = [] }) => [
    ...rows.map((row) => `${row.keys.join(" ")} ${row.description}`),
    ...more,
  ]);
  const hasKeys = keys.some((text) => matchesAll(text, queryTerms));
  const hits = searchManuals(valueIn(useManuals()) ?? [], query).slice(0, MAX_MANUAL_HITS);
  if (blocks.length + tasks.length + shown.length + hits.length === 0 && !hasKeys) {
    return (
      <p class="help__none" role="status">
        {help.nothing}
      </p>
    );
  }
  return (
    <>
      <BlockList drawings={blocks} />
      <TaskList names={tasks} />
      <ExampleList examples={shown} />
      {hasKeys && <KeyList query={query} />}
      {hits.length > 0 && (
        <section>
          <h2>{texts.value.titles.manuals}</h2>
          <ManualHits hits={hits} />
        </section>
      )}
    </>
  );
}
