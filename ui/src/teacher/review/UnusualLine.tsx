import { language, texts } from "../../i18n";
import { unusualText } from "../../prediction/words";
import { unusualRuns } from "./unusual_runs";

/** Says of a run on a real robot what is out of the ordinary; renders nothing for all other runs. */
export function UnusualLine({ run }: { run: string }) {
  const unusual = unusualRuns.value.get(run);
  if (!unusual) return null;
  const voice = { texts: texts.value, language: language.value };
  return (
    <span class="unusual-line" data-testid="unusual">
      {unusualText(unusual, voice)}
    </span>
  );
}
