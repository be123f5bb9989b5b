import type { Example } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { GoalPicture } from "../scene/small/GoalPicture";
import { openExample } from "../studio/program/open_example";

interface ExamplesProps {
  examples: readonly Example[];
  group: string;
}

/** Finished programs as cards with the picture of their path; a press opens a copy, ready to run. */
export function Examples({ examples, group }: ExamplesProps) {
  const labels = texts.value.help.examples;
  return (
    <section class="activities__path" data-testid="examples">
      <h2 id="examples" tabIndex={-1}>
        {labels.title}
      </h2>
      <p class="activities__hint">{labels.hint}</p>
      <ul>
        {examples.map((one) => (
          <li key={one.name}>
            <Button
              kind="bare"
              class="activities__card column gap-1"
              testId="example-card"
              data-example={one.name}
              onPress={() => openExample(group, one)}
            >
              <GoalPicture goal={one.picture} />
              <strong class="activities__title">{one.title}</strong>
              <span class="aside">{one.about}</span>
            </Button>
          </li>
        ))}
      </ul>
    </section>
  );
}
