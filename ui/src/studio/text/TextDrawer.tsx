import { Maximize2, Minimize2 } from "lucide-preact";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Tabs } from "../../kit/Tabs";
import type { ActiveBlock } from "../../run/reducer";
import { type DrawerState, TABS } from "./drawer";
import { IrPanel } from "./IrPanel";
import { PythonPane } from "./PythonPane";

interface TextDrawerProps {
  state: DrawerState;
  document: object | null;
  running: ActiveBlock | null;
  onState(state: DrawerState): void;
  onPlace(document: object): Promise<void>;
}

/** The program as Python text and as its document. */
export function TextDrawer({ state, document, running, onState, onPlace }: TextDrawerProps) {
  return (
    <div class="text card column shrinks-down">
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
  const labels = { python: python.tab, ir: ir.tab };
  return (
    <div class="text__head row middle apart rigid gap-2">
      <Tabs
        label={python.tabs}
        testId="text-tab"
        value={tab}
        options={TABS.map((name) => [name, labels[name], { "data-tab": name }])}
        onChange={(selected) => onState({ ...state, tab: selected })}
      />
      <Button
        kind="plain"
        icon={tall ? Minimize2 : Maximize2}
        label={tall ? python.smaller : python.larger}
        onPress={() => onState({ ...state, tall: !tall })}
      />
    </div>
  );
}
