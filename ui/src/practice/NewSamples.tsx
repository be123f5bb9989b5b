import { useSignal } from "@preact/signals";
import { Video } from "lucide-preact";
import { STORE_LIMITS } from "../api/declared";
import { signsApi } from "../api/signs";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { Field } from "../kit/Field";
import { Form } from "../kit/Form";
import { RadioGroup } from "../kit/RadioGroup";
import { MISSING_LETTERS, MovementDrawing } from "./MovementDrawing";

/**
 * Form that starts to record a new sign: its name, whether it moves, and how to show it to the
 * camera.
 */
export function NewSamples({ classroom }: { classroom: string }) {
  const labels = texts.value.teaching;
  const name = useSignal("");
  const moves = useSignal(false);
  const sign = name.value.trim();
  const record = () => {
    const begin = moves.value ? signsApi.recordMoving : signsApi.record;
    return sign !== "" && begin(classroom, sign);
  };
  return (
    <Form class="column gap-2" onSubmit={record}>
      <RadioGroup
        label={labels.suggested}
        legendClass="imitation__legend"
        class="teaching__letters row middle gap-1"
        optionClass="imitation__letter"
        testId="teach-letter"
        value={sign}
        options={MISSING_LETTERS.map(({ letter }) => [
          letter,
          <MovementDrawing key={letter} letter={letter} />,
          { "data-letter": letter, label: letter },
        ])}
        onChange={(letter: string) => {
          name.value = letter;
          moves.value = MISSING_LETTERS.some((one) => one.letter === letter && one.moves);
        }}
      />
      <div class="teaching__form">
        <Field
          label={labels.name}
          value={name.value}
          maxLength={STORE_LIMITS.MAX_SIGN}
          data-testid="teach-name"
          onText={(text) => {
            name.value = text;
          }}
        />
        <RadioGroup
          label={labels.kind}
          class="imitation__hands"
          testId="teach-kind"
          value={moves.value}
          options={[
            [false, labels.still],
            [true, `${labels.moves} (${labels.experimental})`],
          ]}
          onChange={(chosen: boolean) => {
            moves.value = chosen;
          }}
        />
        <Button submit icon={Video} disabled={sign === ""} testId="teach-record">
          {labels.record}
        </Button>
      </div>
      <p class="teaching__how">{moves.value ? labels.howMoving : labels.howStill}</p>
    </Form>
  );
}
