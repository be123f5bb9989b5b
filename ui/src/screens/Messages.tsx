import { Database, Save, TriangleAlert, Unplug, X } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { opened } from "../app/open_program";
import { route } from "../app/route";
import { connection, notice, type Problem, problem, wordsOf } from "../app/session";
import { TEST } from "../app/testids";
import { texts } from "../i18n";

/** What the person has to know, as lines under the header: never a window in the way. */
export function Messages() {
  const { trouble } = texts.value;
  const gone = { message: trouble.goneTitle, remedy: trouble.gone };
  return (
    <div class="messages" role="status">
      {connection.value === "gone" && (
        <Line words={gone} fault testId={TEST.gone} icon={<Unplug class="icon" />} />
      )}
      {notice.value && (
        <Line words={notice.value} testId={TEST.notice} icon={<Database class="icon" />} />
      )}
      <Unsaved />
      {problem.value && (
        <Line
          words={problem.value}
          fault
          testId={TEST.problem}
          icon={<TriangleAlert class="icon" />}
        >
          <button
            type="button"
            class="button button--plain button--icon"
            aria-label={trouble.close}
            onClick={() => {
              problem.value = null;
            }}
          >
            <X class="icon" aria-hidden="true" />
          </button>
        </Line>
      )}
    </div>
  );
}

/** Why the work is not on disk, when the server itself says so. */
function Unsaved() {
  const save = route.value.screen === "studio" ? opened.value?.autosave : undefined;
  if (save?.state.value !== "failed" || connection.value !== "open") return null;
  const { saved } = texts.value;
  const { message, remedy } = wordsOf(save.problem.value);
  const words = { message, remedy: `${remedy} ${saved.failedRemedy}`.trim() };
  return <Line words={words} fault testId={TEST.unsaved} icon={<Save class="icon" />} />;
}

interface LineProps {
  words: Problem;
  icon: ComponentChildren;
  testId: string;
  fault?: boolean;
  children?: ComponentChildren;
}

function Line({ words, icon, testId, fault = false, children }: LineProps) {
  return (
    <p class={`line-message ${fault ? "line-message--fault" : ""}`} data-testid={testId}>
      {icon}
      <span>
        <strong>{words.message}</strong> {words.remedy}
      </span>
      {children}
    </p>
  );
}
