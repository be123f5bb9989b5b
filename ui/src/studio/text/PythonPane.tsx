import { PencilLine } from "lucide-preact";
import { api } from "../../api/client";
import type { WrittenPython } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Loaded } from "../../kit/requests/Loaded";
import { valueIn } from "../../kit/requests/load_state";
import { useLoaded } from "../../kit/requests/useLoaded";
import type { ActiveBlock } from "../../run/reducer";
import { CodeSheet } from "./CodeSheet";
import { CopyButton } from "./IrPanel";
import { PythonEditor } from "./PythonEditor";

interface PythonPaneProps {
  document: object | null;
  /** The running command of the shown program. */
  running: ActiveBlock | null;
  editing: boolean;
  onEditing(editing: boolean): void;
  /** Replaces the blocks by the blocks of a text without faults. */
  onPlace(document: object): Promise<void>;
}

/** Debounce of the translation to Python. */
const DEBOUNCE_MS = 250;

/** The program as Python text, read-only or in the editor. */
export function PythonPane(props: PythonPaneProps) {
  const { document, running, editing, onEditing, onPlace } = props;
  const written = useLoaded(
    [document, language.value],
    async () => document && api.writePython(document),
    { debounceMs: DEBOUNCE_MS },
  );
  const { python } = texts.value;
  const text = valueIn(written)?.text ?? null;
  if (editing && valueIn(written)) {
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
  return (
    <div class="text__panel column grows shrinks-down">
      <Loaded of={written}>
        {(now) => <Written document={document} written={now} running={running} />}
      </Loaded>
      <div class="text__bar row middle apart rigid gap-2">
        <Button
          icon={PencilLine}
          testId="python-edit"
          disabled={text === null}
          onPress={() => onEditing(true)}
        >
          {python.edit}
        </Button>
        <CopyButton text={text ?? ""} />
      </div>
    </div>
  );
}

interface WrittenProps {
  document: object | null;
  written: WrittenPython | null;
  running: ActiveBlock | null;
}

function Written({ document, written, running }: WrittenProps) {
  const { python } = texts.value;
  const instead = insteadOfText(document, written);
  if (!written?.text || instead) {
    return (
      <p class="text__empty" data-testid="python-empty">
        {instead}
      </p>
    );
  }
  return (
    <CodeSheet
      text={written.text.trimEnd()}
      activeLine={running && lineOf(written.lines, running)}
      label={python.text}
      testId="python-text"
    />
  );
}

/** The text shown if there is no Python text. */
function insteadOfText(document: object | null, written: WrittenPython | null): string {
  const { python } = texts.value;
  if (!document || !written) return "";
  if (written.text === null) return python.broken;
  const { commands = [], functions = [] } = document as Record<string, unknown[]>;
  return commands.length + functions.length === 0 ? python.empty : "";
}

/** The line of the running command. Edits change pointers, so the id of the block is compared first. */
function lineOf(lines: WrittenPython["lines"], { block, pointer }: ActiveBlock): number | null {
  const ofBlock = lines.filter((line) => line.block === block);
  return (ofBlock.find((line) => line.pointer === pointer) ?? ofBlock[0])?.line ?? null;
}
