import { Maximize2, Minimize2 } from "lucide-preact";
import { TEST } from "../../app/testids";
import { texts } from "../../i18n";
import type { LitBlock } from "../reducer";
import { IrPanel } from "./IrPanel";
import { PythonPane } from "./PythonPane";
import "./text.css";

export type TextTab = "python" | "ir";

/** How the drawer stands: which form of the text, how much room it has, whether Python is being written. */
export interface DrawerState {
  readonly tab: TextTab;
  readonly tall: boolean;
  readonly editing: boolean;
}

export const DRAWER: DrawerState = { tab: "python", tall: false, editing: false };

interface TextDrawerProps {
  state: DrawerState;
  document: object | null;
  running: LitBlock | null;
  onState(state: DrawerState): void;
  onPlace(document: object): Promise<void>;
}

/** The program as text: as Python, and as the robot gets it. */
export function TextDrawer({ state, document, running, onState, onPlace }: TextDrawerProps) {
  const { python, ir } = texts.value;
  const { tab, tall, editing } = state;
  const sizeLabel = tall ? python.smaller : python.larger;
  const SizeIcon = tall ? Minimize2 : Maximize2;
  return (
    <div class="text card">
      <div class="text__head">
        <div class="text__tabs" role="tablist" aria-label={python.tabs}>
          {(["python", "ir"] as const).map((name) => (
            <button
              key={name}
              type="button"
              class="text__tab"
              role="tab"
              aria-selected={tab === name}
              disabled={editing && tab !== name}
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
          aria-label={sizeLabel}
          title={sizeLabel}
          onClick={() => onState({ ...state, tall: !tall })}
        >
          <SizeIcon class="icon" aria-hidden="true" />
        </button>
      </div>
      {tab === "ir" ? (
        <IrPanel document={document} />
      ) : (
        <PythonPane
          document={document}
          running={running}
          editing={editing}
          onEditing={(now) => onState({ ...state, editing: now, tall: now })}
          onPlace={onPlace}
        />
      )}
    </div>
  );
}
