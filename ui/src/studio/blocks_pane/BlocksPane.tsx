import {
  AlignVerticalJustifyStart,
  History,
  Layers,
  type LucideIcon,
  Redo2,
  Undo2,
} from "lucide-preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import type { World } from "../../api/model";
import type { KnownSigns } from "../../blocks/known_signs";
import { classOfSigns, LETTERS, signNames, signs } from "../../camera/signs";
import { createEditor, type Editor } from "../../editor";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Select } from "../../kit/Select";
import { UndoBanner } from "../../kit/UndoBanner";
import { lazy } from "../../shell/lazy";
import {
  LEVELS,
  level,
  levelNames,
  missionLevel,
  offered,
  setLevel,
  shown,
} from "../../shell/level";
import { go } from "../../shell/route";
import { problem, program, refreshStatus } from "../../shell/session";
import { theme } from "../../shell/theme";
import { breakpoints } from "../debug/debugging";
import type { StudioControl } from "../studio_control";
import { FaultList } from "./FaultList";
import { InBin } from "./InBin";
import { LessonMission } from "./LessonMission";
import { OtherWindow } from "./OtherWindow";
import { ParallelBranchNotice } from "./ParallelBranchNotice";
import { RestoredVersionBanner } from "./RestoredVersionBanner";
import { SwapReminder } from "./SwapReminder";

const MissionCard = lazy(async () => (await import("../mission/MissionCard")).MissionCard);

export function BlocksPane({ control }: { control: StudioControl }) {
  const { studio } = texts.value;
  return (
    <section class="blocks" aria-label={studio.blocks}>
      <Tools control={control} />
      <LessonMission open={control.open} />
      <InBin open={control.open} />
      <ParallelBranchNotice program={control.open.program} />
      <OtherWindow open={control.open} />
      <RestoredVersionBanner control={control} />
      <Swap control={control} />
      <SwapReminder group={control.open.program.group_id} />
      {/* below all banners, which its sheet must not cover */}
      {control.open.setup.value.activity && <MissionCard control={control} />}
      <Workspace control={control} />
      <FaultList faults={control.open.faults.value} onGo={(fault) => control.goTo(fault)} />
    </section>
  );
}

function Tools({ control }: { control: StudioControl }) {
  const { studio } = texts.value;
  const tool = (testId: string, label: string, icon: LucideIcon, act: (editor: Editor) => void) => (
    <Button
      kind="plain"
      icon={icon}
      testId={testId}
      onPress={() => control.editor && act(control.editor)}
    >
      {label}
    </Button>
  );
  return (
    <div class="blocks__tools row middle rigid gap-1">
      {tool("undo", studio.undo, Undo2, (editor) => editor.undo())}
      {tool("redo", studio.redo, Redo2, (editor) => editor.redo())}
      {tool("tidy", studio.tidy, AlignVerticalJustifyStart, (editor) => editor.tidy())}
      <HistoryButton control={control} />
      <LevelChoice />
    </div>
  );
}

function HistoryButton({ control: { open } }: { control: StudioControl }) {
  const { history } = texts.value.archive;
  const show = async () => {
    // so that the history includes the content on the screen; autosave reports its own failure
    await open.autosave.flush().catch(() => {});
    // without a server the history cannot load: navigation is then blocked
    await refreshStatus();
    go({ screen: "versions", program: open.id, version: null });
  };
  return (
    <Button
      kind="plain"
      icon={History}
      tip={history}
      testId="open-history"
      disabled={open.deleted.value !== null}
      onPress={show}
    >
      {history}
    </Button>
  );
}

function LevelChoice() {
  const labels = texts.value.level;
  return (
    <Select
      class="blocks__level"
      icon={Layers}
      label={labels.label}
      tip={labels.label}
      testId="level"
      value={shown.value}
      options={[
        ...(missionLevel.value?.blocks ? ([["mission", labels.mission]] as const) : []),
        ...LEVELS.map((one) => [one, levelNames()[one]] as const),
      ]}
      onChange={setLevel}
    />
  );
}

/** Offers undo after the whole program was replaced. */
function Swap({ control }: { control: StudioControl }) {
  const { value: replaced } = control.replaced;
  if (!replaced) return null;
  const { python } = texts.value;
  const placed = replaced.now === "placed";
  return (
    <UndoBanner
      text={placed ? python.placed : python.broughtBack}
      action={placed ? python.bringBack : python.placeAgain}
      testId="swap-back"
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

  // before the first paint, so that no empty frame appears
  useLayoutEffect(() => {
    if (!container.current) return;
    const made = createEditor({
      container: container.current,
      language: language.value,
      theme: theme.value,
      mediaPath: "/media/",
      level: level.value,
      offered: offered.value,
      programName: () => program.value?.name ?? control.open.program.name,
      onChange: (content) => control.onEdit(content),
      onNothingToUndo: () => control.undoPast(),
      evaluate: (expression) => control.evaluate(expression),
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
  useEffect(
    () => editor.current?.setLevel(level.value, offered.value),
    [level.value, offered.value],
  );
  useEffect(() => editor.current?.setSigns(signsForBlocks()), [signs.value, control]);
  const { value: world } = control.world;
  useEffect(() => editor.current?.setPlaces(world && placesOf(world)), [world, control]);

  useEffect(() => {
    const now = editor.current;
    if (!now) return;
    now.setLanguage(language.value);
    // saves again, because the response has the faults in the new language
    if (control.open.faults.value.length > 0) control.open.edit(now.content());
  }, [language.value, control]);

  return (
    <div
      class="blocks__editor"
      ref={container}
      data-testid="editor"
      onPointerDownCapture={() => control.missionSheet.close()}
      onKeyDownCapture={() => control.missionSheet.close()}
    />
  );
}

function signsForBlocks(): KnownSigns | null {
  if (!signs.value) return null;
  const named = signNames.value.filter((name) => !LETTERS.includes(name));
  return { named, hasClass: classOfSigns.value !== null };
}

const placesOf = (world: World) => (world.zones ?? []).map(({ name }) => name);

function openIn(editor: Editor, { open }: StudioControl): void {
  try {
    editor.load(open.program.version?.workspace ?? null);
    open.begin(editor.content());
  } catch {
    // blocks of a newer release: the editor shows nothing and must not overwrite them
    editor.setReadOnly(true);
    problem.value = { message: texts.value.studio.unreadable, remedy: "" };
  }
}
