import { FlaskConical, Save, X } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { authoringApi } from "../../api/authoring";
import type { Group, OwnActivityToEdit } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import { useInstance } from "../../kit/instance";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { ActivityEditor } from "./activity_editor";
import { ChecksPart } from "./ChecksPart";
import { criteriaOf } from "./criteria";
import { SolutionPart } from "./SolutionPart";
import { TextsPart } from "./TextsPart";
import { TrialResult } from "./TrialResult";

interface ActivityFormProps {
  /** The activity to change; null for a new one. */
  activity: OwnActivityToEdit | null;
  groups: readonly Group[];
  onSaved(): Promise<void>;
  onCancel(): void;
}

/** Makes an activity from a sample solution, checks and texts. */
export function ActivityForm({ activity, groups, onSaved, onCancel }: ActivityFormProps) {
  const { making: labels } = texts.value;
  const editor = useInstance(() => new ActivityEditor(activity));
  const { busy, fault, act, refuse, clear } = useAction(asTeacher);
  useEffect(() => {
    if (activity) void act(() => editor.measure());
  }, []);
  const { value: trials } = editor.trials;
  const save = async () => {
    const draft = completed(editor);
    if (!draft) refuse(labels.withoutSolution);
    else if (!draft.title.trim()) refuse(labels.withoutTitle);
    else if (await act(() => authoringApi.save(editor.id, draft))) await onSaved();
  };
  return (
    <Form class="panel card making" testId="making-form" onSubmit={save}>
      <SolutionPart editor={editor} groups={groups} />
      <ChecksPart editor={editor} />
      <TextsPart editor={editor} />
      {trials && <TrialResult trials={trials} />}
      <FaultLine fault={fault} />
      <div class="button-row">
        <Button
          icon={FlaskConical}
          disabled={!editor.draft.value}
          testId="making-try"
          onPress={() => {
            clear();
            return act(() => editor.tryOut());
          }}
        >
          {labels.tryOut}
        </Button>
        <Button submit kind="main" icon={Save} busy={busy} testId="making-save">
          {labels.save}
        </Button>
        <Button kind="plain" icon={X} onPress={onCancel}>
          {labels.cancel}
        </Button>
      </div>
    </Form>
  );
}

/** The activity to save. If the teacher wrote no criteria, their text is derived from the checks. */
function completed(editor: ActivityEditor) {
  const { value: draft } = editor.draft;
  const { value: choices } = editor.choices;
  if (!draft || !choices) return null;
  const criteria = draft.criteria?.trim() || criteriaOf(choices, texts.value.making);
  return { ...draft, criteria };
}
