import { Database, TriangleAlert, Unplug, X } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { connection, notice, type Problem, problem } from "../app/session";
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
