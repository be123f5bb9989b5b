import {
  AlignVerticalJustifyStart,
  ChevronDown,
  History,
  Layers,
  Redo2,
  Undo2,
} from "lucide-preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { LEVELS, level, setLevel } from "../app/level";
import { go } from "../app/route";
import { problem, program, refreshStatus } from "../app/session";
import { TEST } from "../app/testids";
import { theme } from "../app/theme";
import { breakpoints } from "../debug/debugging";
import { createEditor, type Editor } from "../editor";
import { language, texts } from "../i18n";
import { BackFromOld } from "./BackFromOld";
import { Elsewhere } from "./Elsewhere";
import { FaultList } from "./FaultList";
import { InBin } from "./InBin";
import { OtherWindow } from "./OtherWindow";
import type { StudioControl } from "./studio_control";
import { Turns } from "./Turns";
import { WayBack } from "./WayBack";

export function BlocksPane({ control }: { control: StudioControl }) {
  const { studio } = texts.value;
  return (
    <section class="blocks" aria-label={studio.blocks}>
      <Tools control={control} />
      <InBin open={control.open} />
      <Elsewhere program={control.open.program} />
      <OtherWindow open={control.open} />
      <BackFromOld control={control} />
      <Swap control={control} />
      <Turns group={control.open.program.group_id} />
      <Workspace control={control} />
      <FaultList faults={control.open.faults.value} onGo={(fault) => control.goTo(fault)} />
    </section>
  );
}

function Tools({ control }: { control: StudioControl }) {
  const { studio } = texts.value;
  const tool = (
    testId: string,
    label: string,
    Icon: typeof Undo2,
    act: (editor: Editor) => void,
  ) => (
    <button
      type="button"
      class="button button--plain"
      data-testid={testId}
      onClick={() => control.editor && act(control.editor)}
    >
      <Icon class="icon" aria-hidden="true" />
      {label}
    </button>
  );
  return (
    <div class="blocks__tools">
      {tool(TEST.undo, studio.undo, Undo2, (editor) => editor.undo())}
      {tool(TEST.redo, studio.redo, Redo2, (editor) => editor.redo())}
      {tool(TEST.tidy, studio.tidy, AlignVerticalJustifyStart, (editor) => editor.tidy())}
      <HistoryButton control={control} />
      <LevelChoice />
    </div>
  );
}

function HistoryButton({ control: { open } }: { control: StudioControl }) {
  const { history } = texts.value.keeping;
  const show = async () => {
    // what is in the line there is what is on the screen here; what cannot be saved says so itself
    await open.autosave.flush().catch(() => {});
    // the blocks would be lost from sight for nothing where there is no server any more
    await refreshStatus();
    go({ screen: "versions", program: open.id, version: null });
  };
  return (
    <button
      type="button"
      class="button button--plain"
      data-testid={TEST.openHistory}
      title={history}
      disabled={open.deleted.value !== null}
      onClick={() => void show()}
    >
      <History class="icon" aria-hidden="true" />
      {history}
    </button>
  );
}

function LevelChoice() {
  const words = texts.value.level;
  const names = { 1: words.first, 2: words.explorer, 3: words.everything };
  return (
    <span class="select blocks__level">
      <Layers class="icon" aria-hidden="true" />
      <select
        aria-label={words.label}
        title={words.label}
        data-testid={TEST.level}
        value={String(level.value)}
        onChange={({ currentTarget: { value } }) => {
          const chosen = LEVELS.find((one) => String(one) === value);
          if (chosen) setLevel(chosen);
        }}
      >
        {LEVELS.map((one) => (
          <option key={one} value={String(one)}>
            {names[one]}
          </option>
        ))}
      </select>
      <ChevronDown class="icon icon--end" aria-hidden="true" />
    </span>
  );
}

/** After a whole program took the place of another: the way back. */
function Swap({ control }: { control: StudioControl }) {
  const { value: replaced } = control.replaced;
  if (!replaced) return null;
  const { python } = texts.value;
  const placed = replaced.now === "placed";
  return (
    <WayBack
      words={placed ? python.placed : python.broughtBack}
      action={placed ? python.bringBack : python.placeAgain}
      testId={TEST.swapBack}
      onBack={() => control.swapBack()}
      onClose={() => {
        control.replaced.value = null;
      }}
    />
  );
}

function Workspace({ control }: { control: StudioControl }) {
  const container = useRef<HTMLDivElement>(null);
  const editor = useRef<Editor | null>(null);

  // before the first paint: a group waits for its blocks, not for an empty frame
  useLayoutEffect(() => {
    if (!container.current) return;
    const made = createEditor({
      container: container.current,
      language: language.value,
      theme: theme.value,
      mediaPath: "/media/",
      level: level.value,
      programName: () => program.value?.name ?? control.open.program.name,
      onChange: (content) => control.onEdit(content),
      onNothingToUndo: () => control.undoPast(),
      peek: (expression) => control.peek(expression),
      onBreakpoints: (ids) => {
        breakpoints.value = ids;
      },
    });
    editor.current = made;
    openIn(made, control);
    const untie = control.attach(made);
    return () => {
      untie();
      made.dispose();
      editor.current = null;
    };
  }, [control]);

  useEffect(() => editor.current?.setTheme(theme.value), [theme.value]);
  useEffect(() => editor.current?.setLevel(level.value), [level.value]);

  useEffect(() => {
    const now = editor.current;
    if (!now) return;
    now.setLanguage(language.value);
    // the faults of the newest version, in the language chosen
    if (control.open.faults.value.length > 0) control.open.edit(now.content());
  }, [language.value, control]);

  return <div class="blocks__editor" ref={container} data-testid={TEST.editor} />;
}

function openIn(editor: Editor, { open }: StudioControl): void {
  try {
    editor.load(open.program.version?.workspace ?? null);
    open.begin(editor.content());
  } catch {
    // blocks of a newer version: shown nothing, and above all nothing saved over them
    editor.setReadOnly(true);
    problem.value = { message: texts.value.studio.unreadable, remedy: "" };
  }
}
