import { History } from "lucide-preact";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";

/** Button that opens the last intact version, if the newest version is damaged. */
export function OpenLastIntact({ at, onPress }: { at: string; onPress(): void }) {
  const time = new Date(at).toLocaleString(language.value, {
    dateStyle: "short",
    timeStyle: "short",
  });
  return (
    <Button icon={History} kind="main" testId="open-sound-version" onPress={onPress}>
      {texts.value.studio.openSound({ time })}
    </Button>
  );
}
