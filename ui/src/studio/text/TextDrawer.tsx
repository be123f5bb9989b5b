import { Maximize2, Minimize2 } from "lucide-preact";
import { TEST } from "../../app/testids";
import { texts } from "../../i18n";
import type { LitBlock } from "../reducer";
import { type DrawerState, TABS } from "./drawer";
import { IrPanel } from "./IrPanel";
import { PythonPane } from "./PythonPane";

interface TextDrawerProps {
  state: DrawerState;
  document: object | null;
  running: LitBlock | null;
  onState(state: DrawerState): void;
  onPlace(document: object): Promise<void>;
}

/** The program as text: as Python, and as the robot gets it. */
export function TextDrawer({ state, document, running, onState, onPlace }: TextDrawerProps) {
  return (
    <div class="text card">
      {!state.editing && <Head state={state} onState={onState} />}
      {state.tab === "ir" ? (
        <IrPanel document={document} />
      ) : (
        <PythonPane
          document={document}
          running={running}
          editing={state.editing}
          onEditing={(editing) => onState({ ...state, editing })}
          onPlace={onPlace}
        />
      )}
    </div>
  );
}

function Head({ state, onState }: Pick<TextDrawerProps, "state" | "onState">) {
  const { python, ir } = texts.value;
  const { tab, tall } = state;
  const label = tall ? python.smaller : python.larger;
  const Icon = tall ? Minimize2 : Maximize2;
  return (
    <div class="text__head">
      <div class="text__tabs" role="tablist" aria-label={python.tabs} onKeyDown={toOtherTab}>
        {TABS.map((name) => (
          <button
            key={name}
            type="button"
            class="text__tab"
            role="tab"
            aria-selected={tab === name}
            tabIndex={tab === name ? 0 : -1}
            data-testid={TEST.textTab}
            data-tab={name}
            onClick={() => onState({ ...state, tab: name })}
          >
            {name === "python" ? python.tab : ir.tab}
          </button>
        ))}
      </div>
      <button
        type="button"
        class="button button--plain button--icon"
        aria-label={label}
        title={label}
        onClick={() => onState({ ...state, tall: !tall })}
      >
        <Icon class="icon" aria-hidden="true" />
      </button>
    </div>
  );
}

/** The arrows go from one of the two tabs to the other. */
function toOtherTab(event: KeyboardEvent & { currentTarget: HTMLElement }): void {
  if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
  const other = event.currentTarget.querySelector<HTMLElement>("[aria-selected=false]");
  other?.focus();
  other?.click();
}
