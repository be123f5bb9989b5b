import { useSignal } from "@preact/signals";
import { Check, CircleHelp, Redo2, Square, TriangleAlert, Undo2 } from "lucide-preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { worldTitle } from "../api/model";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { listen } from "../kit/listen";
import { report } from "../shell/session";
import { Board } from "./board/Board";
import { checkOnChange } from "./checks";
import type { EditorStore } from "./editor_store";
import { exportWorld, isRefusal, type Refusal, worldIn } from "./files";
import { pressedAnywhere } from "./keys";
import { ObjectPanel, StartPanel } from "./ObjectPanel";
import { objectOf } from "./plan";
import { Toolbox } from "./Toolbox";
import { WorldPanel } from "./WorldPanel";

interface WorldEditorProps {
  store: EditorStore;
  /** Whether the first change replaces the group's own world. */
  replaces: boolean;
  onOwn(): void;
  /** Null while the program has no world of its own. */
  onForget: (() => void) | null;
  /** Null while no run is live. */
  onStop: (() => void) | null;
  onDone(): void;
}

/** Editor of the group's own world, shown in place of blocks and floor. */
export function WorldEditor({
  store,
  replaces,
  onOwn,
  onForget,
  onStop,
  onDone,
}: WorldEditorProps) {
  const labels = texts.value.world;
  const section = useRef<HTMLElement>(null);
  const refusal = useSignal<Refusal | null>(null);
  useEffect(() => checkOnChange(store, report), [store]);
  useEffect(() => section.current?.focus(), []);
  useLayoutEffect(() => followKeys(store), [store]);
  const importFile = (file: File) => {
    refusal.value = null;
    worldIn(file).then((answer) => {
      if (isRefusal(answer)) refusal.value = answer;
      else store.replace(answer, worldTitle(answer, language.peek()));
    }, report);
  };
  return (
    <section
      ref={section}
      class="world-editor column"
      aria-label={labels.title}
      tabIndex={-1}
      data-testid="world-editor"
      onDragOver={(event) => event.preventDefault()}
      onDrop={(event) => {
        event.preventDefault();
        const [file] = event.dataTransfer?.files ?? [];
        if (file) importFile(file);
      }}
    >
      <Bar store={store} onStop={onStop} onDone={onDone} />
      {refusal.value && (
        <Refused
          refusal={refusal.value}
          onClose={() => {
            refusal.value = null;
          }}
        />
      )}
      {replaces && <Replaces onOwn={onOwn} />}
      <div class="world-editor__table grows shrinks-down">
        <Toolbox store={store} />
        <Board store={store}>
          <Hint store={store} />
        </Board>
        <Side store={store} onForget={onForget} onFile={importFile} />
      </div>
    </section>
  );
}

/** Handles keys of the whole page, because the focused element may have been deleted. Ignores typing in fields. */
function followKeys(store: EditorStore): () => void {
  return listen(window, {
    keydown: (event) => {
      const isTyping = event.target instanceof HTMLInputElement;
      if (!isTyping && pressedAnywhere(store, event)) event.preventDefault();
    },
  });
}

interface BarProps {
  store: EditorStore;
  onStop: (() => void) | null;
  onDone(): void;
}

function Bar({ store, onStop, onDone }: BarProps) {
  const { studio, world, run } = texts.value;
  return (
    <div class="world-editor__bar row middle rigid gap-1">
      <Button
        icon={Undo2}
        kind="plain"
        testId="world-undo"
        disabled={!store.canUndo.value}
        onPress={() => store.undo()}
      >
        {studio.undo}
      </Button>
      <Button
        icon={Redo2}
        kind="plain"
        testId="world-redo"
        disabled={!store.canRedo.value}
        onPress={() => store.redo()}
      >
        {studio.redo}
      </Button>
      <h2>{world.title}</h2>
      {onStop && (
        <Button icon={Square} kind="stop" onPress={onStop}>
          {run.stop}
        </Button>
      )}
      <Button
        icon={Check}
        kind="main"
        class="world-editor__done"
        testId="world-done"
        onPress={onDone}
      >
        {world.done}
      </Button>
    </div>
  );
}

function Refused({ refusal, onClose }: { refusal: Refusal; onClose(): void }) {
  const { world, trouble } = texts.value;
  const [first] = refusal.faults;
  const why = first ? `${first.message} ${first.remedy}` : world.tooLarge;
  return (
    <div class="line-message line-message--fault" role="alert" data-testid="world-refused">
      <span>
        <strong>{world.fileRefused}</strong> {why}
      </span>
      <Button onPress={onClose}>{trouble.close}</Button>
    </div>
  );
}

function Replaces({ onOwn }: { onOwn(): void }) {
  const { world } = texts.value;
  return (
    <div class="line-message" role="status">
      <span>{world.replaces}</span>
      <Button testId="world-own-instead" onPress={onOwn}>
        {world.ownInstead}
      </Button>
    </div>
  );
}

/** One line with instructions for the current tool. */
function Hint({ store }: { store: EditorStore }) {
  const { hints } = texts.value.world;
  const tool = store.tool.value;
  const isEmpty = store.isBare && tool === "select" && store.selected.value === null;
  const isHeld = tool === "select" && store.selected.value !== null;
  return (
    <p class="world-hint card row middle grows gap-3" role="status" data-testid="world-hint">
      <CircleHelp class="icon" aria-hidden="true" />
      {isEmpty ? hints.empty : isHeld ? hints.selected : hints[tool]}
    </p>
  );
}

interface SideProps {
  store: EditorStore;
  onForget: (() => void) | null;
  onFile(file: File): void;
}

function Side({ store, onForget, onFile }: SideProps) {
  const plan = store.shown.value;
  const selected = store.selected.value;
  const object = objectOf(plan, selected);
  return (
    <div class="world-side card column shrinks-down">
      {object && <ObjectPanel store={store} plan={plan} object={object} key={object.id} />}
      {selected === "start" && <StartPanel store={store} plan={plan} />}
      {!object && selected !== "start" && (
        <WorldPanel
          store={store}
          plan={plan}
          onForget={onForget}
          onFile={onFile}
          onExport={() =>
            exportWorld(store.document.value, worldTitle(store.world.value, language.value))
          }
        />
      )}
      <Faults store={store} />
    </div>
  );
}

function Faults({ store }: { store: EditorStore }) {
  const { value: faults } = store.faults;
  if (faults.length === 0) return null;
  return (
    <div class="world-faults" role="status" data-testid="world-faults">
      <h3>
        <TriangleAlert class="icon" aria-hidden="true" />
        {texts.value.studio.faultsTitle({ count: faults.length })}
      </h3>
      <p>{texts.value.world.keptBefore}</p>
      <ul>
        {faults.map((fault) => (
          <li key={`${fault.pointer} ${fault.code}`}>
            <Button
              kind="bare"
              class="faults__fault row middle apart gap-3"
              testId="world-fault"
              data-code={fault.code}
              onPress={() => {
                store.choose("select");
                store.select(store.aboutFault(fault));
              }}
            >
              <span>
                <strong>{fault.message}</strong> {fault.remedy}
              </span>
            </Button>
          </li>
        ))}
      </ul>
    </div>
  );
}
