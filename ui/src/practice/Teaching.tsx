import { useSignal } from "@preact/signals";
import { Trash2, Video } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { NO_CLASS } from "../api/classes";
import { STORE_LIMITS } from "../api/declared";
import type { Sign } from "../api/model";
import { signsApi } from "../api/signs";
import { recording } from "../camera/sight";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { Field } from "../kit/Field";
import { Form } from "../kit/Form";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { classroom, shownClass } from "../shell/classroom";
import { groupsAndClasses } from "../shell/first_answers";
import { group } from "../shell/session";
import { TEST } from "../shell/testids";

/** The class of the group that works, or the one that the start screen shows; only a class teaches signs. */
export function Teaching() {
  if (!group.value) return <OfShownClass />;
  const { classroom_id } = group.value;
  return classroom_id && <OfClass key={classroom_id} id={classroom_id} />;
}

function OfShownClass() {
  const found = useLoaded("classes", groupsAndClasses, { onFailed: () => {} });
  if (found.status !== "ready") return null;
  const [groups, classes] = found.value;
  const id = shownClass(classroom.value, classes, groups);
  return id === NO_CLASS ? null : <OfClass key={id} id={id} />;
}

/** A sign is shown to the camera, counted while it is recorded, listed, and deleted again. */
function OfClass({ id }: { id: string }) {
  const words = texts.value.teaching;
  const signs = useLoaded(id, () => signsApi.use(id), { onFailed: () => {} });
  const told = recording.value?.classroom === id ? recording.value : null;
  useEffect(() => {
    if (told?.is_kept) void signs.again();
  }, [told]);
  useEffect(() => () => void signsApi.stop().catch(() => {}), []);
  return (
    <details class="teaching card">
      <summary class="teaching__title">{words.title}</summary>
      <NewSamples id={id} />
      <p class="teaching__told" role="status" data-testid={TEST.teachTold}>
        {told && wordsOfRecording(told)}
      </p>
      <Loaded of={signs}>
        {(found) => (
          <Taught
            signs={found.filter((one) => one.n_samples > 0)}
            onForget={async (sign) => signs.set(await signsApi.forget(id, sign))}
          />
        )}
      </Loaded>
    </details>
  );
}

function NewSamples({ id }: { id: string }) {
  const words = texts.value.teaching;
  const name = useSignal("");
  const isEmpty = name.value.trim() === "";
  return (
    <Form class="teaching__form" onSubmit={() => isEmpty || signsApi.record(id, name.value.trim())}>
      <Field
        label={words.name}
        value={name.value}
        maxLength={STORE_LIMITS.MAX_SIGN}
        data-testid={TEST.teachName}
        onText={(text) => {
          name.value = text;
        }}
      />
      <Button submit icon={Video} disabled={isEmpty} testId={TEST.teachRecord}>
        {words.record}
      </Button>
    </Form>
  );
}

interface TaughtProps {
  signs: readonly Sign[];
  onForget(sign: string): Promise<void>;
}

function Taught({ signs, onForget }: TaughtProps) {
  const words = texts.value.teaching;
  return (
    <ul class="teaching__signs">
      {signs.map(({ name, n_samples }) => (
        <li key={name} data-testid={TEST.taughtSign} data-sign={name}>
          <strong>{name}</strong> {words.samples(n_samples)}
          <Button
            icon={Trash2}
            label={words.forget(name)}
            testId={TEST.forgetSign}
            onPress={() => onForget(name)}
          />
        </li>
      ))}
    </ul>
  );
}

function wordsOfRecording(told: NonNullable<typeof recording.value>): string {
  const words = texts.value.teaching;
  if (told.code !== null) return `${told.message} ${told.remedy}`;
  return told.is_kept
    ? words.learnt(told.sign)
    : words.counted(told.sign, told.n_samples, told.n_wanted);
}
