import { useSignal } from "@preact/signals";
import { Check, CircleHelp, Redo2, Square, TriangleAlert, Undo2 } from "lucide-preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { worldTitle } from "../api/model";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { Board } from "./Board";
import { keepChecked } from "./checks";
import type { WorldDesk } from "./desk";
import { exportWorld, isRefusal, type Refusal, worldIn } from "./files";
import { pressedAnywhere } from "./keys";
import { thingOf } from "./plan";
import { StartPanel, ThingPanel } from "./ThingPanel";
import { Toolbox } from "./Toolbox";
import { WorldPanel } from "./WorldPanel";

interface WorldEditorProps {
  desk: WorldDesk;
  /** The first change takes the place of the group's own world. */
  replaces: boolean;
  onOwn(): void;
  /** Null while the program has no world of its own. */
  onForget: (() => void) | null;
  /** Null while no robot is on its way. */
  onStop: (() => void) | null;
  onDone(): void;
}

/** Draws the group's own world, in place of blocks and floor. */
export function WorldEditor({ desk, replaces, onOwn, onForget, onStop, onDone }: WorldEditorProps) {
  const words = texts.value.world;
  const section = useRef<HTMLElement>(null);
  const refusal = useSignal<Refusal | null>(null);
  useEffect(() => keepChecked(desk, report), [desk]);
  useEffect(() => section.current?.focus(), []);
  useLayoutEffect(() => followKeys(desk), [desk]);
  const take = (file: File) => {
    refusal.value = null;
    worldIn(file).then((answer) => {
      if (isRefusal(answer)) refusal.value = answer;
      else desk.replace(answer, worldTitle(answer, language.peek()));
    }, report);
  };
  return (
    <section
      ref={section}
      class="world-editor"
      aria-label={words.title}
      tabIndex={-1}
      data-testid={TEST.worldEditor}
      onDragOver={(event) => event.preventDefault()}
      onDrop={(event) => {
        event.preventDefault();
        const [file] = event.dataTransfer?.files ?? [];
        if (file) take(file);
      }}
    >
      <Bar desk={desk} onStop={onStop} onDone={onDone} />
      {refusal.value && (
        <Refused
          refusal={refusal.value}
          onClose={() => {
            refusal.value = null;
          }}
        />
      )}
      {replaces && <Replaces onOwn={onOwn} />}
      <div class="world-editor__table">
        <Toolbox desk={desk} />
        <Board desk={desk}>
          <Hint desk={desk} />
        </Board>
        <Side desk={desk} onForget={onForget} onFile={take} />
      </div>
    </section>
  );
}

/** Wherever the focus is, for what had it may be gone; but not while a text is typed. */
function followKeys(desk: WorldDesk): () => void {
  const down = (event: KeyboardEvent) => {
    const isTyping = event.target instanceof HTMLInputElement;
    if (!isTyping && pressedAnywhere(desk, event)) event.preventDefault();
  };
  window.addEventListener("keydown", down);
  return () => window.removeEventListener("keydown", down);
}

interface BarProps {
  desk: WorldDesk;
  onStop: (() => void) | null;
  onDone(): void;
}

function Bar({ desk, onStop, onDone }: BarProps) {
  const { studio, world, run } = texts.value;
  return (
    <div class="world-editor__bar">
      <button
        type="button"
        class="button button--plain"
        data-testid={TEST.worldUndo}
        disabled={!desk.canUndo.value}
        onClick={() => desk.undo()}
      >
        <Undo2 class="icon" aria-hidden="true" />
        {studio.undo}
      </button>
      <button
        type="button"
        class="button button--plain"
        data-testid={TEST.worldRedo}
        disabled={!desk.canRedo.value}
        onClick={() => desk.redo()}
      >
        <Redo2 class="icon" aria-hidden="true" />
        {studio.redo}
      </button>
      <h2>{world.title}</h2>
      {onStop && (
        <button type="button" class="button button--stop" onClick={onStop}>
          <Square class="icon" aria-hidden="true" />
          {run.stop}
        </button>
      )}
      <button
        type="button"
        class="button button--run world-editor__done"
        data-testid={TEST.worldDone}
        onClick={onDone}
      >
        <Check class="icon" aria-hidden="true" />
        {world.done}
      </button>
    </div>
  );
}

function Refused({ refusal, onClose }: { refusal: Refusal; onClose(): void }) {
  const { world, trouble } = texts.value;
  const [first] = refusal.faults;
  const why = first ? `${first.message} ${first.remedy}` : world.tooLarge;
  return (
    <div class="line-message line-message--fault" role="alert" data-testid={TEST.worldRefused}>
      <span>
        <strong>{world.fileRefused}</strong> {why}
      </span>
      <button type="button" class="button" onClick={onClose}>
        {trouble.close}
      </button>
    </div>
  );
}

function Replaces({ onOwn }: { onOwn(): void }) {
  const { world } = texts.value;
  return (
    <div class="line-message" role="status">
      <span>{world.replaces}</span>
      <button type="button" class="button" data-testid={TEST.worldOwnInstead} onClick={onOwn}>
        {world.ownInstead}
      </button>
    </div>
  );
}

/** What to do now, in a line. */
function Hint({ desk }: { desk: WorldDesk }) {
  const { hints } = texts.value.world;
  const tool = desk.tool.value;
  const isEmpty = desk.isBare && tool === "select" && desk.selected.value === null;
  const isHeld = tool === "select" && desk.selected.value !== null;
  return (
    <p class="world-hint card" role="status" data-testid={TEST.worldHint}>
      <CircleHelp class="icon" aria-hidden="true" />
      {isEmpty ? hints.empty : isHeld ? hints.selected : hints[tool]}
    </p>
  );
}

interface SideProps {
  desk: WorldDesk;
  onForget: (() => void) | null;
  onFile(file: File): void;
}

function Side({ desk, onForget, onFile }: SideProps) {
  const plan = desk.shown.value;
  const selected = desk.selected.value;
  const thing = thingOf(plan, selected);
  return (
    <div class="world-side card">
      {thing && <ThingPanel desk={desk} plan={plan} thing={thing} key={thing.id} />}
      {selected === "start" && <StartPanel desk={desk} plan={plan} />}
      {!thing && selected !== "start" && (
        <WorldPanel
          desk={desk}
          plan={plan}
          onForget={onForget}
          onFile={onFile}
          onExport={() =>
            exportWorld(desk.document.value, worldTitle(desk.world.value, language.value))
          }
        />
      )}
      <Faults desk={desk} />
    </div>
  );
}

function Faults({ desk }: { desk: WorldDesk }) {
  const { value: faults } = desk.faults;
  if (faults.length === 0) return null;
  return (
    <div class="world-faults" role="status" data-testid={TEST.worldFaults}>
      <h3>
        <TriangleAlert class="icon" aria-hidden="true" />
        {texts.value.studio.faultsTitle(faults.length)}
      </h3>
      <p>{texts.value.world.keptBefore}</p>
      <ul>
        {faults.map((fault) => (
          <li key={`${fault.pointer} ${fault.code}`}>
            <button
              type="button"
              class="faults__fault"
              data-testid={TEST.worldFault}
              data-code={fault.code}
              onClick={() => {
                desk.choose("select");
                desk.select(desk.aboutFault(fault));
              }}
            >
              <span>
                <strong>{fault.message}</strong> {fault.remedy}
              </span>
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}
