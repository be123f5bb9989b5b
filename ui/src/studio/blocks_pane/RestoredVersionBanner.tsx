import { useEffect } from "preact/hooks";
import { texts } from "../../i18n";
import { UndoBanner } from "../../kit/UndoBanner";
import { restoredFrom } from "../program/restored_from";
import type { StudioControl } from "../studio_control";

/** Names the version that a restored old version replaced, with a link back to it. */
export function RestoredVersionBanner({ control }: { control: StudioControl }) {
  const forget = () => {
    restoredFrom.value = null;
  };
  useEffect(() => forget, []);
  const { value: step } = restoredFrom;
  if (step?.program !== control.open.id) return null;
  const labels = texts.value.archive;
  const { from, instead } = step;
  const back = async () => {
    forget();
    await control.restoreVersion(instead.id);
  };
  return (
    <UndoBanner
      text={labels.wentOn({ old: from.number, left: instead.number })}
      action={labels.backTo({ left: instead.number })}
      testId="version-return"
      onBack={back}
      onClose={forget}
    />
  );
}
