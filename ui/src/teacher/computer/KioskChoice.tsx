import { DoorOpen } from "lucide-preact";
import { kioskApi } from "../../api/kiosk";
import type { KioskState } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import { asTeacher } from "../../shell/teacher/teacher_session";

/** Whether the window opens in kiosk mode, and, in that mode, the button that closes it. */
export function KioskChoice() {
  const { kiosk: labels } = texts.value;
  const found = useLoaded("kiosk", kioskApi.state);
  return (
    <section class="panel card column gap-3" aria-labelledby="kiosk-title">
      <h2 id="kiosk-title">{labels.title}</h2>
      <Loaded of={found}>{(state) => <Choice state={state} onChange={found.set} />}</Loaded>
    </section>
  );
}

interface ChoiceProps {
  state: KioskState;
  onChange(state: KioskState): void;
}

function Choice({ state, onChange }: ChoiceProps) {
  const { kiosk: labels } = texts.value;
  const { busy, fault, act } = useAction(asTeacher);
  const choose = (isChosen: boolean) => act(async () => onChange(await kioskApi.choose(isChosen)));
  return (
    <>
      <label class="row middle gap-2">
        <input
          type="checkbox"
          checked={state.is_chosen || state.is_by_command}
          disabled={busy || state.is_by_command}
          data-testid="kiosk"
          onChange={({ currentTarget }) => void choose(currentTarget.checked)}
        />
        {labels.choose}
      </label>
      <p class="labelled__hint">{hint(state)}</p>
      {state.is_active && (
        <>
          <p class="labelled__hint">{labels.printing}</p>
          <div class="button-row">
            <Button
              icon={DoorOpen}
              busy={busy}
              testId="kiosk-leave"
              onPress={() => act(kioskApi.leave)}
            >
              {labels.leave}
            </Button>
          </div>
        </>
      )}
      <FaultLine fault={fault} />
    </>
  );
}

function hint({ is_by_command, has_window }: KioskState): string {
  const { kiosk: labels } = texts.value;
  if (is_by_command) return labels.byCommand;
  return has_window ? labels.hint : labels.withoutWindow;
}
