import { classesApi } from "../../api/classes";
import { texts } from "../../i18n";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import { ComputerCode } from "./ComputerCode";
import { ComputerName } from "./ComputerName";
import { NewPin } from "./NewPin";
import { TurnMinutes } from "./TurnMinutes";

/** The settings of this PC: its name, the PIN, how often pupils take turns. */
export function ComputerPart() {
  const computer = useLoaded("computer", () => classesApi.computer());
  return (
    <>
      <h1>{texts.value.teacher.computer.title}</h1>
      <Loaded of={computer}>
        {({ name, fingerprint }) => (
          <>
            <ComputerName name={name} />
            {fingerprint && <ComputerCode code={fingerprint} />}
          </>
        )}
      </Loaded>
      <NewPin />
      <TurnMinutes />
    </>
  );
}
