import { classesApi } from "../../api/classes";
import { texts } from "../../i18n";
import { Field } from "../../kit/Field";
import { useDraft } from "../useDraft";
import { SettingForm, useSetting } from "./SettingForm";

interface ComputerNameProps {
  name: string;
}

/** Form for the name of this PC. */
export function ComputerName({ name }: ComputerNameProps) {
  const { computer: labels } = texts.value.teacher;
  const setting = useSetting();
  const { draft, field } = useDraft({ name }, setting.clear);
  return (
    <SettingForm
      setting={setting}
      done={labels.kept}
      hint={labels.nameHint}
      buttonId="keep-computer"
      onSave={() => setting.save(() => classesApi.renameComputer(draft.name))}
    >
      <Field label={labels.name} maxLength={60} data-testid="computer-name" {...field("name")} />
    </SettingForm>
  );
}
