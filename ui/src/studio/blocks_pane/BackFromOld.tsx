import { useEffect } from "preact/hooks";
import { report } from "../app/session";
import { TEST } from "../app/testids";
import { wentOn } from "../app/went_on";
import { texts } from "../i18n";
import type { StudioControl } from "./studio_control";
import { WayBack } from "./WayBack";

/** After an old version took the place of the newest: where that is now, with the way back to it. */
export function BackFromOld({ control }: { control: StudioControl }) {
  const forget = () => {
    wentOn.value = null;
  };
  useEffect(() => forget, []);
  const { value: step } = wentOn;
  if (step?.program !== control.open.id) return null;
  const words = texts.value.keeping;
  const { from, instead } = step;
  const back = async () => {
    forget();
    await control.backTo(instead.id);
  };
  return (
    <WayBack
      words={words.wentOn(from.number, instead.number)}
      action={words.backTo(instead.number)}
      testId={TEST.versionReturn}
      onBack={() => void back().catch(report)}
      onClose={forget}
    />
  );
}
