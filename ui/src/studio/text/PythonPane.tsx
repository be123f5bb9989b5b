import { PencilLine } from "lucide-preact";
import { useEffect, useState } from "preact/hooks";
import { api } from "../../api/client";
import type { WrittenPython } from "../../api/model";
import { report } from "../../app/session";
import { TEST } from "../../app/testids";
import { language, texts } from "../../i18n";
import type { LitBlock } from "../reducer";
import { CodeSheet } from "./CodeSheet";
import { CopyButton } from "./IrPanel";
import { PythonEditor } from "./PythonEditor";

interface PythonPaneProps {
  document: object | null;
  /** The command that runs, of the program that is shown. */
  running: LitBlock | null;
  editing: boolean;
  onEditing(editing: boolean): void;
  /** A text was read without faults, and is to become blocks. */
  onPlace(document: object): Promise<void>;
}

/** The program as Python, to be read, and to be written. */
export function PythonPane(props: PythonPaneProps) {
  const { document, running, editing, onEditing, onPlace } = props;
  const written = useWritten(document);
  const { python } = texts.value;
  const text = written?.text ?? null;
  if (editing && written) {
    return (
      <PythonEditor
        original={text ?? ""}
        onLeave={() => onEditing(false)}
        onPlace={async (made) => {
          await onPlace(made);
          onEditing(false);
        }}
      />
    );
  }
  const instead = insteadOfText(document, written);
  return (
    <div class="text__panel">
      {text === null || instead ? (
        <p class="text__empty" data-testid={TEST.pythonEmpty}>
          {instead}
        </p>
      ) : (
        <CodeSheet
          text={text.trimEnd()}
          lit={running && written ? lineOf(written.lines, running) : null}
          label={python.text}
          testId={TEST.pythonText}
        />
      )}
      <div class="text__bar">
        <button
          type="button"
          class="button"
          disabled={text === null}
          data-testid={TEST.pythonEdit}
          onClick={() => onEditing(true)}
        >
          <PencilLine class="icon" aria-hidden="true" />
          {python.edit}
        </button>
        <CopyButton text={text ?? ""} />
      </div>
    </div>
  );
}

/** What is said where there is nothing to read yet. */
function insteadOfText(document: object | null, written: WrittenPython | null): string {
  const { python } = texts.value;
  if (!document || !written) return "";
  if (written.text === null) return python.broken;
  const { commands = [], functions = [] } = document as Record<string, unknown[]>;
  return commands.length + functions.length === 0 ? python.empty : "";
}

/** An edit is written as Python when the hand rests. */
const QUIET_MS = 250;

function useWritten(document: object | null): WrittenPython | null {
  const [written, setWritten] = useState<WrittenPython | null>(null);
  useEffect(() => {
    if (!document) return;
    let left = false;
    const write = () =>
      api.writePython(document).then((answer) => {
        if (!left) setWritten(answer);
      }, report);
    const timer = setTimeout(write, written ? QUIET_MS : 0);
    return () => {
      left = true;
      clearTimeout(timer);
    };
  }, [document, language.value]);
  return written;
}

/** The line of the command that runs. After an edit places have moved, but blocks keep their ids. */
function lineOf(lines: WrittenPython["lines"], { block, pointer }: LitBlock): number | null {
  const ofBlock = lines.filter((line) => line.block === block);
  return (ofBlock.find((line) => line.pointer === pointer) ?? ofBlock[0])?.line ?? null;
}
