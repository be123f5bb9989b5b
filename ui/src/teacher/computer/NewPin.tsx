import { texts } from "../../i18n";
import { PinField } from "../../kit/Field";
import { choosePin } from "../../shell/teacher/teacher_session";
import { pinFault } from "../sign_in/pin";
import { useDraft } from "../useDraft";
import { SettingForm, useSetting } from "./SettingForm";

/** Form for a new PIN. */
export function NewPin() {
  const { computer: labels, prepare } = texts.value.teacher;
  const setting = useSetting();
  const { draft, field, reset } = useDraft({ pin: "", again: "" }, setting.clear);
  const save = async () => {
    const wrong = pinFault(draft.pin, draft.again, prepare);
    if (wrong) setting.refuse(wrong);
    else if (await setting.save(() => choosePin(draft.pin))) reset();
  };
  return (
    <SettingForm
      title={labels.pin}
      setting={setting}
      done={labels.pinKept}
      hint={prepare.pinHint}
      buttonId="keep-pin"
      onSave={save}
    >
      <PinField label={labels.newPin} data-testid="new-pin" {...field("pin")} />
      <PinField label={labels.newPinAgain} data-testid="new-pin-again" {...field("again")} />
    </SettingForm>
  );
}
