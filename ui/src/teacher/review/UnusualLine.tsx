import { language, texts } from "../../i18n";
import { unusualText } from "../../prediction/words";
import { unusualRuns } from "./unusual_runs";

interface UnusualLineProps {
  run: string;
  /** Without what is usual for the robot. */
  isShort?: boolean;
}

/** Says of a run on a real robot what is out of the ordinary; renders nothing for all other runs. */
export function UnusualLine({ run, isShort = false }: UnusualLineProps) {
  const unusual = unusualRuns.value.get(run);
  if (!unusual) return null;
  const voice = { texts: texts.value, language: language.value };
  const { text, usual } = unusualText(unusual, voice);
  return (
    <span class="unusual-line" title={isShort ? usual : undefined} data-testid="unusual">
      {isShort ? text : `${text} ${usual}`}
    </span>
  );
}
