import { Blocks, CircleCheck, Undo2 } from "lucide-preact";
import type { RefObject } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { api } from "../../api/client";
import type { Fault } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { settled } from "../../kit/report";
import { valueIn } from "../../kit/requests/load_state";
import { useLoaded } from "../../kit/requests/useLoaded";
import { CodeSheet, showLine } from "./CodeSheet";
import { listenToTyping } from "./keys";
import { PythonFaults, positionOf } from "./PythonFaults";
import { offsetOf } from "./typing";

interface PythonEditorProps {
  original: string;
  onLeave(): void;
  onPlace(document: object): Promise<void>;
}

/** Result of checking the current text. */
interface Check {
  readonly text: string;
  readonly document: object | null;
  readonly faults: readonly Fault[];
}

/** Debounce of the check. */
const DEBOUNCE_MS = 350;

async function checkOf(text: string): Promise<Check> {
  const { document, faults } = await api.readPython(text);
  return { text, document: document as object | null, faults };
}

/** Editor of the program as Python text, with its faults. */
export function PythonEditor({ original, onLeave, onPlace }: PythonEditorProps) {
  const { python } = texts.value;
  const [text, setText] = useState(original);
  const check = valueIn(
    useLoaded([text, language.value], () => checkOf(text), { debounceMs: DEBOUNCE_MS }),
  );
  const field = useRef<HTMLTextAreaElement>(null);
  const faults = check?.faults ?? [];
  const isChanged = text !== original;
  const document = isChanged && check?.text === text ? check.document : null;
  const place = async () => document && onPlace(document);
  useEffect(() => field.current?.focus(), []);
  useEffect(() => {
    return field.current ? listenToTyping(field.current, () => void settled(place())) : undefined;
  }, [document]);
  const jump = (fault: Fault) => {
    const { line, column } = positionOf(fault);
    const at = offsetOf(text, line, column);
    field.current?.focus();
    field.current?.setSelectionRange(at, at);
    const sheet = field.current?.closest<HTMLElement>(".code");
    if (sheet) showLine(sheet, line);
  };
  return (
    <div class="text__panel column grows shrinks-down">
      <CodeSheet
        text={text}
        label={python.text}
        faulty={new Set(faults.map((fault) => positionOf(fault).line))}
      >
        <TextField elementRef={field} text={text} onText={setText} />
      </CodeSheet>
      {faults.length > 0 && <PythonFaults faults={faults} onGo={jump} />}
      <State check={check?.text === text ? check : null} isChanged={isChanged} />
      <div class="text__bar row middle apart rigid gap-2">
        <Button icon={Undo2} testId="python-leave" onPress={onLeave}>
          {python.leave}
        </Button>
        <Button kind="main" icon={Blocks} testId="python-put" disabled={!document} onPress={place}>
          {python.put}
        </Button>
      </div>
    </div>
  );
}

interface TextFieldProps {
  elementRef: RefObject<HTMLTextAreaElement>;
  text: string;
  onText(text: string): void;
}

function TextField({ elementRef, text, onText }: TextFieldProps) {
  return (
    <textarea
      ref={elementRef}
      value={text}
      wrap="off"
      spellcheck={false}
      autocapitalize="off"
      autocomplete="off"
      aria-label={texts.value.python.text}
      aria-describedby="python-keys"
      data-testid="python-editor"
      onInput={(event) => onText(event.currentTarget.value)}
    />
  );
}

function State({ check, isChanged }: { check: Check | null; isChanged: boolean }) {
  const { python } = texts.value;
  const state = !check ? "checking" : check.faults.length > 0 ? "faulty" : "fine";
  const name = state === "fine" && !isChanged ? "unchanged" : state;
  const label =
    name === "faulty" ? python.faults({ count: check?.faults.length ?? 0 }) : python[name];
  return (
    <div class="text__states">
      <p
        class={`text__state row middle grows shrinks gap-2 text__state--${name}`}
        role="status"
        data-testid="python-state"
        data-state={name}
      >
        {name === "fine" && <CircleCheck class="icon" aria-hidden="true" />}
        {label}
      </p>
      {/* hidden if there are faults, which need the space */}
      <p id="python-keys" class={name === "unchanged" ? "aside" : "visually-hidden"}>
        {python.keys}
      </p>
    </div>
  );
}
