import { Database, Download, FileX, Save, TriangleAlert, Unplug, X } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { api } from "../api/client";
import { ApiError } from "../api/errors";
import type { Notice } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { ProblemText } from "../kit/requests/ProblemText";
import { type Problem, problemOf } from "../kit/requests/problem";
import { ToStart } from "../kit/ToStart";
import { fileName, saveFile } from "../shell/files/save_file";
import { connection, group, notice, problem, showNotice } from "../shell/session";
import { mayPass } from "../studio/program/autosave";
import { type OpenProgram, programOnScreen } from "../studio/program/open_program";
import { ExportGroup } from "../work/ProgramFile";

/** Notices and errors as lines under the header, never as dialogs. */
export function Messages() {
  const { trouble } = texts.value;
  const disconnected = { message: trouble.goneTitle, remedy: trouble.gone };
  return (
    <div role="status">
      {connection.value === "gone" && (
        <MessageLine text={disconnected} fault testId="gone" icon={<Unplug class="icon" />} />
      )}
      {notice.value && !isSuperseded(notice.value, unsavedProblem()) && (
        <MessageLine text={notice.value} testId="notice" icon={<Database class="icon" />}>
          {notice.value.code === "database_place_missing" && (
            <Button testId="begin-empty" onPress={beginEmpty}>
              {trouble.beginEmpty}
            </Button>
          )}
          {notice.value.code === "database_not_lasting" && group.value && (
            <ExportGroup group={group.value} />
          )}
        </MessageLine>
      )}
      <Unsaved />
      {problem.value && (
        <MessageLine
          text={problem.value}
          fault
          testId="problem"
          icon={<TriangleAlert class="icon" />}
        >
          <Button
            kind="plain"
            icon={X}
            label={trouble.close}
            onPress={() => {
              problem.value = null;
            }}
          />
        </MessageLine>
      )}
    </div>
  );
}

/** Starts with an empty database, although the folder of the work is not available. */
async function beginEmpty(): Promise<void> {
  showNotice((await api.beginEmpty()).database.notice);
}

/** Why the open program could not be saved; null if it is saved. */
function unsavedProblem(): unknown {
  const { value: open } = programOnScreen;
  return open?.autosave.state.value === "failed" ? open.autosave.problem.value : null;
}

/**
 * Whether the error of a failed save replaces the notice: the same problem is shown once. On a full
 * disk the notice "nearly full" would wrongly claim that saving still works.
 */
export function isSuperseded({ code }: Pick<Notice, "code">, unsaved: unknown): boolean {
  return isCode(unsaved, code) || (isCode(unsaved, "disk_full") && code === "disk_nearly_full");
}

const isCode = (error: unknown, code: string) => error instanceof ApiError && error.code === code;

/** Why the server could not save the work. */
function Unsaved() {
  const { value: open } = programOnScreen;
  if (!open || connection.value !== "open") return null;
  if (open.deleted.value) return <Deleted open={open} what={open.deleted.value} />;
  const { autosave: save } = open;
  if (save.state.value !== "failed") return null;
  const { saved } = texts.value;
  const { remedy, ...why } = problemOf(save.problem.value);
  const waitHint = mayPass(save.problem.value) ? saved.failedRemedy : "";
  const text = { ...why, remedy: `${remedy} ${waitHint}`.trim() };
  return <MessageLine text={text} fault testId="unsaved" icon={<Save class="icon" />} />;
}

/** The open program or its group was deleted; its text can still be saved as a file. */
function Deleted({ open, what }: { open: OpenProgram; what: "program" | "group" }) {
  const { deleted } = texts.value.trouble;
  const { document } = open.content.value ?? {};
  const canSave = Boolean(document) && !open.isEmpty;
  const text = { message: deleted[what], remedy: canSave ? deleted.take : deleted.leave };
  return (
    <MessageLine text={text} fault testId="deleted" icon={<FileX class="icon" />}>
      {canSave && document && (
        <Button
          icon={Download}
          testId="take-text"
          onPress={() => saveText(document, open.program.name)}
        >
          {deleted.takeText}
        </Button>
      )}
      <ToStart />
    </MessageLine>
  );
}

async function saveText(document: object, name: string): Promise<void> {
  const { text } = await api.writePython(document);
  if (text) saveFile(`${fileName(name, "programa")}.py`, new Blob([text]));
}

interface MessageLineProps {
  text: Problem;
  icon: ComponentChildren;
  testId: string;
  fault?: boolean;
  children?: ComponentChildren;
}

function MessageLine({ text, icon, testId, fault = false, children }: MessageLineProps) {
  return (
    <div class={`line-message ${fault ? "line-message--fault" : ""}`} data-testid={testId}>
      {icon}
      <div>
        <ProblemText of={text} />
      </div>
      {children}
    </div>
  );
}
