import { Trash2 } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { NO_CLASS } from "../api/classes";
import type { Sign } from "../api/model";
import { signsApi } from "../api/signs";
import { problemText } from "../camera/problem_text";
import { recording } from "../camera/sight";
import { chooseSigns, signs } from "../camera/signs";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { useLoaded } from "../kit/requests/useLoaded";
import { classroom, shownClass } from "../shell/classroom";
import { groupsAndClasses } from "../shell/first_answers";
import { group } from "../shell/session";
import { NewSamples } from "./NewSamples";

/**
 * Teaching signs to the camera, for the class of the open group. Without a group, the class of the
 * start screen is used.
 */
export function Teaching() {
  if (!group.value) return <OfShownClass />;
  const { classroom_id } = group.value;
  return classroom_id ? <OfClass key={classroom_id} id={classroom_id} /> : <WithoutClass />;
}

function OfShownClass() {
  const found = useLoaded("classes", groupsAndClasses, { onFailed: () => {} });
  if (found.status !== "ready") return null;
  const [groups, classes] = found.value;
  const id = shownClass(classroom.value, classes, groups);
  return id === NO_CLASS ? <WithoutClass /> : <OfClass key={id} id={id} />;
}

/** Makes the camera recognise letters only: without a class there are no taught signs. */
function WithoutClass() {
  useEffect(() => void chooseSigns(null), []);
  return null;
}

/** Records samples of a sign for a class, counts them, and lists or deletes the taught signs. */
function OfClass({ id }: { id: string }) {
  const labels = texts.value.teaching;
  const status = recording.value?.classroom === id ? recording.value : null;
  useEffect(() => void chooseSigns(id), [id]);
  useEffect(() => () => void signsApi.stop().catch(() => {}), []);
  return (
    <details class="teaching card">
      <summary class="teaching__title">{labels.title}</summary>
      <NewSamples classroom={id} />
      <p class="teaching__told" role="status" data-testid="teach-told">
        {status && recordingText(status)}
      </p>
      <Taught
        signs={(signs.value ?? []).filter((one) => one.n_samples + one.n_movements > 0)}
        onForget={(sign) => signsApi.forget(id, sign)}
      />
    </details>
  );
}

interface TaughtProps {
  signs: readonly Sign[];
  onForget(sign: string): Promise<unknown>;
}

function Taught({ signs, onForget }: TaughtProps) {
  const labels = texts.value.teaching;
  return (
    <ul class="teaching__signs">
      {signs.map(({ name, n_samples, n_movements }) => (
        <li key={name} data-testid="taught-sign" data-sign={name}>
          <strong>{name}</strong>
          {n_samples > 0 && <span>{labels.samples({ count: n_samples })}</span>}
          {n_movements > 0 && <span>{labels.movements({ count: n_movements })}</span>}
          <Button
            icon={Trash2}
            label={labels.forget({ sign: name })}
            testId="forget-sign"
            onPress={() => onForget(name)}
          />
        </li>
      ))}
    </ul>
  );
}

function recordingText(status: NonNullable<typeof recording.value>): string {
  const labels = texts.value.teaching;
  if (status.code !== null) {
    const { message, remedy } = problemText({ ...status, code: status.code });
    return `${message} ${remedy}`;
  }
  if (status.is_kept) return labels.learnt({ sign: status.sign });
  const counted = status.is_moving ? labels.countedMoving : labels.counted;
  return counted({ sign: status.sign, n: status.n_samples, of: status.n_wanted });
}
