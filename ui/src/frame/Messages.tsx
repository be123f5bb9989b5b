import { Database, Download, FileX, House, Save, TriangleAlert, Unplug, X } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { api } from "../api/client";
import { type OpenProgram, onDesk } from "../app/open_program";
import { fileName, saveFile } from "../app/save_file";
import { connection, notice, type Problem, problem, report, wordsOf } from "../app/session";
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
  const { value: open } = onDesk;
  if (!open || connection.value !== "open") return null;
  if (open.deleted.value) return <Deleted open={open} what={open.deleted.value} />;
  const { autosave: save } = open;
  if (save.state.value !== "failed") return null;
  const { saved } = texts.value;
  const { message, remedy } = wordsOf(save.problem.value);
  const words = { message, remedy: `${remedy} ${saved.failedRemedy}`.trim() };
  return <Line words={words} fault testId={TEST.unsaved} icon={<Save class="icon" />} />;
}

/** The work has no place here any more: what is on the screen can still be taken along as text. */
function Deleted({ open, what }: { open: OpenProgram; what: "program" | "group" }) {
  const { deleted, back } = texts.value.trouble;
  const { document } = open.content.value ?? {};
  const canTake = Boolean(document) && !open.isEmpty;
  const words = { message: deleted[what], remedy: canTake ? deleted.take : deleted.leave };
  return (
    <Line words={words} fault testId={TEST.deleted} icon={<FileX class="icon" />}>
      {canTake && document && (
        <button
          type="button"
          class="button"
          data-testid={TEST.takeText}
          onClick={() => void takeText(document, open.program.name).catch(report)}
        >
          <Download class="icon" aria-hidden="true" />
          {deleted.takeText}
        </button>
      )}
      <a class="button" href="#/">
        <House class="icon" aria-hidden="true" />
        {back}
      </a>
    </Line>
  );
}

async function takeText(document: object, name: string): Promise<void> {
  const { text } = await api.writePython(document);
  if (text) saveFile(`${fileName(name, "programa")}.py`, new Blob([text]));
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
