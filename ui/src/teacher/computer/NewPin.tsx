import { texts } from "../../i18n";
import { PinField } from "../../kit/Field";
import { choosePin } from "../../shell/teacher/teacher_session";
import { pinFault } from "../sign_in/pin";
import { useDraft } from "../useDraft";
import { SettingForm, useSetting } from "./SettingForm";

/** Form for a new PIN. */
export function NewPin() {
  const { computer: say, prepare } = texts.value.teacher;
  const setting = useSetting();
  const { draft, field, reset } = useDraft({ pin: "", again: "" }, setting.clear);
  const keep = async () => {
    const wrong = pinFault(draft.pin, draft.again, prepare);
    if (wrong) setting.refuse(wrong);
    else if (await setting.keep(() => choosePin(draft.pin))) reset();
  };
  return (
    <SettingForm
      title={say.pin}
      setting={setting}
      done={say.pinKept}
      hint={prepare.pinHint}
      buttonId="keep-pin"
      onKeep={keep}
    >
      <PinField label={say.newPin} data-testid="new-pin" {...field("pin")} />
      <PinField label={say.newPinAgain} data-testid="new-pin-again" {...field("again")} />
    </SettingForm>
  );
}
