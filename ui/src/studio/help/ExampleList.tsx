import type { Example } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { GoalPicture } from "../../scene/small/GoalPicture";
import { openExample } from "../program/open_example";
import { useHelpContent } from "./help_content";

/** Examples; a press opens a copy. */
export function ExampleList({ examples }: { examples: readonly Example[] }) {
  const { open } = useHelpContent();
  const { help } = texts.value;
  if (examples.length === 0) return null;
  return (
    <ul class="help__examples" aria-label={help.examples.title}>
      {examples.map((one) => (
        <li key={one.name}>
          <Button
            kind="bare"
            class="help__example row middle gap-2"
            tip={help.openExample}
            testId="help-example"
            data-example={one.name}
            onPress={() => openExample(open.program.group_id, one)}
          >
            <GoalPicture goal={one.picture} />
            <span>
              <strong>{one.title}</strong>
              <span class="help__about">{one.about}</span>
            </span>
          </Button>
        </li>
      ))}
    </ul>
  );
}
