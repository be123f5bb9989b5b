import { useSignal } from "@preact/signals";
import { Plus, Undo2 } from "lucide-preact";
import { authoringApi } from "../../api/authoring";
import { api } from "../../api/client";
import type { OwnActivity, OwnActivityToEdit } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Loaded } from "../../kit/requests/Loaded";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { useTeacherLoaded } from "../useTeacherLoaded";
import { ActivityForm } from "./ActivityForm";
import { OwnActivityRow } from "./OwnActivityRow";

/** Content of the form: an activity, or "new"; null without a form. */
type InForm = OwnActivityToEdit | "new" | null;

/** The activities that were made on this PC, and the form for an activity. */
export function ActivitiesPart() {
  const { making: labels } = texts.value;
  const found = useTeacherLoaded(language.value, loadAll);
  const form = useSignal<InForm>(null);
  const deleted = useSignal<OwnActivity | null>(null);
  const close = () => {
    form.value = null;
  };
  const remove = async (one: OwnActivity) => {
    await asTeacher(() => authoringApi.remove(one.id));
    deleted.value = one;
    await found.reload();
  };
  return (
    <>
      <h1>{labels.title}</h1>
      <p class="teacher__hint">{labels.intro}</p>
      <Deleted one={deleted} onBack={found.reload} />
      <Loaded of={found}>
        {({ activities, groups }) =>
          form.value ? (
            <ActivityForm
              key={form.value === "new" ? "new" : form.value.id}
              activity={form.value === "new" ? null : form.value}
              groups={groups}
              onSaved={async () => {
                close();
                await found.reload();
              }}
              onCancel={close}
            />
          ) : (
            <>
              <Button
                kind="main"
                icon={Plus}
                testId="making-new"
                onPress={() => {
                  form.value = "new";
                }}
              >
                {labels.make}
              </Button>
              {activities.length === 0 && <p class="teacher__hint">{labels.empty}</p>}
              <OwnActivityList
                activities={activities}
                onEdit={(activity) => {
                  form.value = activity;
                }}
                onDelete={remove}
              />
            </>
          )
        }
      </Loaded>
    </>
  );
}

interface OwnActivityListProps {
  activities: readonly OwnActivity[];
  onEdit(activity: OwnActivityToEdit | null): void;
  onDelete(one: OwnActivity): Promise<void>;
}

function OwnActivityList({ activities, onEdit, onDelete }: OwnActivityListProps) {
  return (
    <ul class="making__list">
      {activities.map((one) => (
        <OwnActivityRow
          key={one.id}
          activity={one}
          onEdit={async () => onEdit((await asTeacher(() => authoringApi.one(one.id))) ?? null)}
          onDelete={() => onDelete(one)}
        />
      ))}
    </ul>
  );
}

async function loadAll() {
  const [activities, groups] = await Promise.all([authoringApi.list(), api.groups()]);
  return { activities, groups };
}

interface DeletedProps {
  one: { value: OwnActivity | null };
  onBack(): Promise<void>;
}

function Deleted({ one, onBack }: DeletedProps) {
  const { making: labels } = texts.value;
  const { value: deleted } = one;
  if (!deleted) return null;
  const undo = async () => {
    await asTeacher(() => authoringApi.restore(deleted.id));
    one.value = null;
    await onBack();
  };
  return (
    <div class="notice-box button-row" role="status">
      <span>{labels.deleted({ title: deleted.title })}</span>
      <Button icon={Undo2} testId="making-undo" onPress={undo}>
        {labels.takeBack}
      </Button>
    </div>
  );
}
