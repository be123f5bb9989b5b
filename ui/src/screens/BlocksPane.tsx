import { AlignVerticalJustifyStart, Redo2, Undo2 } from "lucide-preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { problem, program, report } from "../app/session";
import { TEST } from "../app/testids";
import { theme } from "../app/theme";
import type { Editor } from "../editor";
import { language, texts } from "../i18n";
import { loadEditor } from "./editor_loader";
import { FaultList } from "./FaultList";
import type { StudioControl } from "./studio_control";

export function BlocksPane({ control }: { control: StudioControl }) {
  const { studio } = texts.value;
  return (
    <section class="blocks" aria-label={studio.blocks}>
      <Tools control={control} />
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
    </div>
  );
}

function Workspace({ control }: { control: StudioControl }) {
  const container = useRef<HTMLDivElement>(null);
  const editor = useRef<Editor | null>(null);

  // before the first paint: a group waits for its blocks, not for an empty frame
  useLayoutEffect(() => {
    let left = false;
    let untie = () => {};
    loadEditor().then(({ createEditor }) => {
      if (left || !container.current) return;
      const made = createEditor({
        container: container.current,
        language: language.value,
        theme: theme.value,
        mediaPath: "/media/",
        programName: () => program.value?.name ?? "",
        onChange: (content) => control.onEdit(content),
      });
      editor.current = made;
      openIn(made, control);
      untie = control.attach(made);
    }, report);
    return () => {
      left = true;
      untie();
      editor.current?.dispose();
      editor.current = null;
    };
  }, [control]);

  useEffect(() => editor.current?.setTheme(theme.value), [theme.value]);

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
    open.content.value = editor.content();
  } catch {
    // blocks of a newer version: shown nothing, and above all nothing saved over them
    editor.setReadOnly(true);
    problem.value = { message: texts.value.studio.unreadable, remedy: "" };
  }
}
