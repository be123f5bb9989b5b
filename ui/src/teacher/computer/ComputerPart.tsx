import { classesApi } from "../../api/classes";
import { texts } from "../../i18n";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import { ComputerName } from "./ComputerName";
import { KioskChoice } from "./KioskChoice";
import { NewPin } from "./NewPin";
import { SettingChoice } from "./SettingChoice";

/** The settings of this PC, such as its name, the PIN and the swap interval of pupils. */
export function ComputerPart() {
  const { computer: labels } = texts.value.teacher;
  const computer = useLoaded("computer", () => classesApi.computer());
  return (
    <>
      <h1>{labels.title}</h1>
      <Loaded of={computer}>{({ name }) => <ComputerName name={name} />}</Loaded>
      <NewPin />
      <SettingChoice
        name="pinel_turns"
        title={labels.turns}
        hint={labels.turnsHint}
        options={labels.turnsEvery}
      />
      <SettingChoice
        name="pinel_loudness"
        title={labels.loudness}
        hint={labels.loudnessHint}
        options={labels.loudnessOf}
      />
      <KioskChoice />
    </>
  );
}
