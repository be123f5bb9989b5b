import { useSignal } from "@preact/signals";
import { Blocks } from "lucide-preact";
import { authoringApi } from "../../api/authoring";
import { api } from "../../api/client";
import { type Group, worldTitle } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Field } from "../../kit/Field";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import { LabelledSelect, Select, type SelectOption } from "../../kit/Select";
import { go } from "../../shell/route";
import { worlds } from "../../shell/session";
import { asTeacher } from "../../shell/teacher/teacher_session";
import type { ActivityEditor } from "./activity_editor";

interface SolutionPartProps {
  editor: ActivityEditor;
  groups: readonly Group[];
}

/** Chooses the sample solution among the programs of all groups, its world and its inputs. */
export function SolutionPart({ editor, groups }: SolutionPartProps) {
  const { making: labels } = texts.value;
  const own = groups.find(({ of_teacher }) => of_teacher);
  const group = useSignal(editor.id ? "" : (own?.id ?? ""));
  const others = groups.filter((one) => one !== own);
  const options = [
    ...(own ? [[own.id, labels.solution.mine] as const] : []),
    ...others.map(({ id, name }): SelectOption<string> => [id, name]),
  ];
  return (
    <section class="making__part">
      <h2>{labels.solution.title}</h2>
      <p class="teacher__hint">{labels.solution.hint}</p>
      <div class="teacher__row">
        <LabelledSelect
          label={labels.solution.group}
          value={group.value}
          testId="making-group"
          options={[["", editor.id ? labels.solution.kept : labels.solution.choose], ...options]}
          onChange={(id) => {
            group.value = id;
          }}
        />
        <BuildButton />
        {group.value && <Programs key={group.value} group={group.value} editor={editor} />}
      </div>
      {editor.stage.value && <WorldAndInputs editor={editor} />}
      {editor.faults.value.map((fault) => (
        <FaultLine key={fault.pointer} fault={fault} />
      ))}
      {editor.proposal.value?.finished === false && (
        <p class="notice-box">{labels.solution.unfinished}</p>
      )}
    </section>
  );
}

/** Opens a new program of the teacher in the studio. */
function BuildButton() {
  const { fault, act } = useAction(asTeacher);
  const build = () =>
    act(async () => go({ screen: "studio", program: (await authoringApi.newProgram()).id }));
  return (
    <>
      <Button icon={Blocks} testId="making-build" onPress={build}>
        {texts.value.making.solution.build}
      </Button>
      <FaultLine fault={fault} />
    </>
  );
}

function Programs({ group, editor }: { group: string; editor: ActivityEditor }) {
  const { solution: labels } = texts.value.making;
  const programs = useLoaded(group, () => api.programs(group));
  const chosen = useSignal("");
  const { fault, act, refuse } = useAction(asTeacher);
  const choose = async (id: string) => {
    chosen.value = id;
    let canBe = true;
    const done = await act(async () => {
      canBe = !id || (await editor.setProgram(id));
    });
    if (done && !canBe) refuse(labels.cannot);
  };
  return (
    <Loaded of={programs}>
      {(list) => (
        <label class="labelled">
          <span class="labelled__label">{labels.program}</span>
          <Select
            value={chosen.value}
            testId="making-program"
            options={[
              ["", labels.choose],
              ...list.map(({ id, name }): SelectOption<string> => [id, name]),
            ]}
            onChange={choose}
          />
          <FaultLine fault={fault} />
        </label>
      )}
    </Loaded>
  );
}

const OF_SOLUTION = "";

function WorldAndInputs({ editor }: { editor: ActivityEditor }) {
  const { solution: labels } = texts.value.making;
  const world = editor.stage.value?.world;
  const shown = typeof world === "string" ? world : OF_SOLUTION;
  const shipped = worlds.value.map(
    (one): SelectOption<string> => [one.name, worldTitle(one, language.value)],
  );
  const own: SelectOption<string>[] = shown === OF_SOLUTION ? [[OF_SOLUTION, labels.ownWorld]] : [];
  const { fault, act } = useAction(asTeacher);
  const input = (name: "gestures" | "answers") => ({
    label: labels[name],
    value: editor.inputs.value[name],
    placeholder: labels.none,
    onText: (text: string) => {
      editor.inputs.value = { ...editor.inputs.value, [name]: text };
    },
    onBlur: () => void act(() => editor.measure()),
  });
  return (
    <div class="teacher__row">
      <LabelledSelect
        label={labels.world}
        value={shown}
        testId="making-world"
        options={[...own, ...shipped]}
        onChange={(name) => name && act(() => editor.setWorld(name))}
      />
      <Field {...input("gestures")} />
      <Field {...input("answers")} />
      <FaultLine fault={fault} />
    </div>
  );
}
