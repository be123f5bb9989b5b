import { texts } from "../../i18n";
import { BlockList } from "./BlockList";
import { ExampleList } from "./ExampleList";
import { useHelpContent } from "./help_content";
import { TASKS, type TaskName } from "./tasks";

/** Tasks, each with its blocks and with examples that open as copies. */
export function TaskList({ names }: { names: readonly TaskName[] }) {
  return (
    <>
      {names.map((name) => (
        <Task key={name} name={name} />
      ))}
    </>
  );
}

function Task({ name }: { name: TaskName }) {
  const { drawings, examples } = useHelpContent();
  const { help } = texts.value;
  const contents: { blocks: readonly string[]; examples: readonly string[] } = TASKS[name];
  const offered = drawings.all.filter(({ type }) => contents.blocks.includes(type));
  return (
    <section class="help__task" data-testid="help-task" data-task={name}>
      <h2>{help.tasks[name]}</h2>
      <BlockList drawings={offered} />
      {offered.length < contents.blocks.length && <p class="help__more">{help.moreInLevel}</p>}
      <ExampleList examples={examples.filter((one) => contents.examples.includes(one.name))} />
    </section>
  );
}
