import { Blocks, CircleCheck, Undo2 } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { api } from "../../api/client";
import type { Fault } from "../../api/model";
import { report } from "../../app/session";
import { TEST } from "../../app/testids";
import { language, texts } from "../../i18n";
import { CodeSheet, showLine } from "./CodeSheet";
import { listenToTyping } from "./keys";
import { PythonFaults, placeOf } from "./PythonFaults";
import { offsetOf } from "./typing";

interface PythonEditorProps {
  original: string;
  onLeave(): void;
  onPlace(document: object): Promise<void>;
}

/** What is known of the text as it stands. */
interface Check {
  readonly text: string;
  readonly document: object | null;
  readonly faults: readonly Fault[];
}

/** Python to be written, with what is wrong in it, until it can become blocks. */
export function PythonEditor({ original, onLeave, onPlace }: PythonEditorProps) {
  const { python } = texts.value;
  const [text, setText] = useState(original);
  const check = useCheck(text);
  const field = useRef<HTMLTextAreaElement>(null);
  const faults = check?.faults ?? [];
  const isChanged = text !== original;
  const document = isChanged && check?.text === text ? check.document : null;
  const place = () => {
    if (document) onPlace(document).catch(report);
  };
  useEffect(() => field.current?.focus(), []);
  useEffect(() => (field.current ? listenToTyping(field.current, place) : undefined), [document]);
  const jump = (fault: Fault) => {
    const { line, column } = placeOf(fault);
    const at = offsetOf(text, line, column);
    field.current?.focus();
    field.current?.setSelectionRange(at, at);
    const sheet = field.current?.closest<HTMLElement>(".code");
    if (sheet) showLine(sheet, line);
  };
  return (
    <div class="text__panel">
      <CodeSheet
        text={text}
        label={python.text}
        faulty={new Set(faults.map((fault) => placeOf(fault).line))}
      >
        <textarea
          ref={field}
          value={text}
          wrap="off"
          spellcheck={false}
          autocapitalize="off"
          autocomplete="off"
          aria-label={python.text}
          aria-describedby="python-keys"
          data-testid={TEST.pythonEditor}
          onInput={(event) => setText(event.currentTarget.value)}
        />
      </CodeSheet>
      {faults.length > 0 && <PythonFaults faults={faults} onGo={jump} />}
      <State check={check?.text === text ? check : null} isChanged={isChanged} />
      <div class="text__bar">
        <button type="button" class="button" data-testid={TEST.pythonLeave} onClick={onLeave}>
          <Undo2 class="icon" aria-hidden="true" />
          {python.leave}
        </button>
        <button
          type="button"
          class="button button--run"
          disabled={!document}
          data-testid={TEST.pythonPut}
          onClick={place}
        >
          <Blocks class="icon" aria-hidden="true" />
          {python.put}
        </button>
      </div>
    </div>
  );
}

function State({ check, isChanged }: { check: Check | null; isChanged: boolean }) {
  const { python } = texts.value;
  const state = !check ? "checking" : check.faults.length > 0 ? "faulty" : "fine";
  const name = state === "fine" && !isChanged ? "unchanged" : state;
  const words = name === "faulty" ? python.faults(check?.faults.length ?? 0) : python[name];
  return (
    <div class="text__states">
      <p
        class={`text__state text__state--${name}`}
        role="status"
        data-testid={TEST.pythonState}
        data-state={name}
      >
        {name === "fine" && <CircleCheck class="icon" aria-hidden="true" />}
        {words}
      </p>
      {/* known once it is read; what is to be mended needs the room more */}
      <p id="python-keys" class={name === "unchanged" ? "text__keys" : "visually-hidden"}>
        {python.keys}
      </p>
    </div>
  );
}

/** The text is read when the hand rests. */
const QUIET_MS = 350;

function useCheck(text: string): Check | null {
  const [check, setCheck] = useState<Check | null>(null);
  useEffect(() => {
    let left = false;
    const read = () =>
      api.readPython(text).then(({ document, faults }) => {
        if (!left) setCheck({ text, document: document as object | null, faults });
      }, report);
    const timer = setTimeout(read, check ? QUIET_MS : 0);
    return () => {
      left = true;
      clearTimeout(timer);
    };
  }, [text, language.value]);
  return check;
}
