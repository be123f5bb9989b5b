import { FlaskConical, Save, X } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { makingApi } from "../../api/making";
import type { Group, OwnActivityToEdit } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import { useInstance } from "../../kit/instance";
import { useAct } from "../../kit/requests/act";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { ChecksPart } from "./ChecksPart";
import { criteriaOf } from "./criteria";
import { Maker } from "./maker";
import { SolutionPart } from "./SolutionPart";
import { TextsPart } from "./TextsPart";
import { TrialResult } from "./TrialResult";

interface ActivityFormProps {
  /** The activity to change; null for a new one. */
  kept: OwnActivityToEdit | null;
  groups: readonly Group[];
  onSaved(): Promise<void>;
  onCancel(): void;
}

/** Makes an activity from a sample solution, checks and texts. */
export function ActivityForm({ kept, groups, onSaved, onCancel }: ActivityFormProps) {
  const { making: say } = texts.value;
  const maker = useInstance(() => new Maker(kept));
  const { busy, fault, act, refuse, clear } = useAct(asTeacher);
  useEffect(() => {
    if (kept) void act(() => maker.measure());
  }, []);
  const { value: trials } = maker.trials;
  const save = async () => {
    const draft = completed(maker);
    if (!draft) refuse(say.withoutSolution);
    else if (!draft.title.trim()) refuse(say.withoutTitle);
    else if (await act(() => makingApi.keep(maker.id, draft))) await onSaved();
  };
  return (
    <Form class="panel card making" testId="making-form" onSubmit={save}>
      <SolutionPart maker={maker} groups={groups} />
      <ChecksPart maker={maker} />
      <TextsPart maker={maker} />
      {trials && <TrialResult trials={trials} />}
      <FaultLine fault={fault} />
      <div class="button-row">
        <Button
          icon={FlaskConical}
          disabled={!maker.draft.value}
          testId="making-try"
          onPress={() => {
            clear();
            return act(() => maker.tryOut());
          }}
        >
          {say.tryOut}
        </Button>
        <Button submit kind="main" icon={Save} busy={busy} testId="making-save">
          {say.save}
        </Button>
        <Button kind="plain" icon={X} onPress={onCancel}>
          {say.cancel}
        </Button>
      </div>
    </Form>
  );
}

/** What is kept: without a text of its own, what counts is said by the checks. */
function completed(maker: Maker) {
  const { value: draft } = maker.draft;
  const { value: choices } = maker.choices;
  if (!draft || !choices) return null;
  const criteria = draft.criteria?.trim() || criteriaOf(choices, texts.value.making);
  return { ...draft, criteria };
}
