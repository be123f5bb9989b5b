import type { KnownComputerList } from "../../api/model";
import { language, texts } from "../../i18n";
import { relativeTime } from "../../i18n/format";
import { Button } from "../../kit/Button";
import { counted } from "./outcome";

interface UndecidedProps {
  deletions: KnownComputerList["undecided"];
  /** Merges the file again, so that the question appears again. */
  onAsk(path: string): Promise<void>;
}

/** Unresolved deletions of other PCs: this PC still has the data, because nobody has decided. */
export function Undecided({ deletions, onAsk }: UndecidedProps) {
  const labels = texts.value.exchange;
  if (deletions.length === 0) return null;
  const at = (iso: string) => relativeTime(iso, new Date(), language.value, texts.value);
  return (
    <div class="notice-box exchange__undecided" data-testid="undecided">
      <strong>{labels.undecided.title}</strong>
      <ul>
        {deletions.map((one) => (
          <li key={one.path}>
            <span>
              {labels.undecided.line({
                computer: one.computer,
                work: counted(one, labels) || labels.programs({ count: 0 }),
              })}{" "}
              <span class="exchange__about">
                {labels.undecided.file({ name: one.name, when: at(one.exported_at) })}
              </span>
            </span>
            <Button onPress={() => onAsk(one.path)}>{labels.undecided.ask}</Button>
          </li>
        ))}
      </ul>
    </div>
  );
}
