import { saysAll, wordsOf } from "../../blocks/toolbox/search";
import { texts } from "../../i18n";
import { BlockList } from "./BlockList";
import { ExampleList } from "./ExampleList";
import { useHelpContent } from "./help_content";
import { KeyList } from "./KeyList";
import { keyGroups } from "./keys";
import { TaskList } from "./TaskList";
import { TASK_NAMES } from "./tasks";

/** What the query finds: blocks first, then what can be done, examples, keys. */
export function Found({ query }: { query: string }) {
  const { drawings, examples } = useHelpContent();
  const { help } = texts.value;
  const wanted = wordsOf(query);
  const blocks = drawings.find(query);
  const tasks = TASK_NAMES.filter((name) => saysAll(help.tasks[name], wanted));
  const shown = examples.filter(({ title, about }) => saysAll(`${title} ${about}`, wanted));
  const keys = keyGroups(texts.value).flatMap(({ rows, more = [] }) => [
    ...rows.map((row) => `${row.keys.join(" ")} ${row.words}`),
    ...more,
  ]);
  const hasKeys = keys.some((words) => saysAll(words, wanted));
  if (blocks.length + tasks.length + shown.length === 0 && !hasKeys) {
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
    </>
  );
}
