import { useSignal } from "@preact/signals";
import { api } from "../../api/client";
import { type Group, worldTitle } from "../../api/model";
import { language, texts } from "../../i18n";
import { Field } from "../../kit/Field";
import { useAct } from "../../kit/requests/act";
import { FaultLine } from "../../kit/requests/FaultLine";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import { Select, type SelectOption } from "../../kit/Select";
import { worlds } from "../../shell/session";
import { asTeacher } from "../../shell/teacher/teacher_session";
import type { Maker } from "./maker";

interface SolutionPartProps {
  maker: Maker;
  groups: readonly Group[];
}

/** Chooses the sample solution among the programs of all groups, its world and its inputs. */
export function SolutionPart({ maker, groups }: SolutionPartProps) {
  const { making: say } = texts.value;
  const group = useSignal("");
  const options = groups.map(({ id, name }): SelectOption<string> => [id, name]);
  return (
    <section class="making__part">
      <h2>{say.solution.title}</h2>
      <p class="teacher__hint">{say.solution.hint}</p>
      <div class="teacher__row">
        <label class="labelled">
          <span class="labelled__label">{say.solution.group}</span>
          <Select
            value={group.value}
            testId="making-group"
            options={[["", maker.id ? say.solution.kept : say.solution.choose], ...options]}
            onChange={(id) => {
              group.value = id;
            }}
          />
        </label>
        {group.value && <Programs key={group.value} group={group.value} maker={maker} />}
      </div>
      {maker.stage.value && <WorldAndInputs maker={maker} />}
      {maker.faults.value.map((fault) => (
        <FaultLine key={fault.pointer} fault={fault} />
      ))}
      {maker.proposal.value?.finished === false && (
        <p class="notice-box">{say.solution.unfinished}</p>
      )}
    </section>
  );
}

function Programs({ group, maker }: { group: string; maker: Maker }) {
  const { solution: say } = texts.value.making;
  const programs = useLoaded(group, () => api.programs(group));
  const chosen = useSignal("");
  const { fault, act, refuse } = useAct(asTeacher);
  const take = async (id: string) => {
    chosen.value = id;
    let canBe = true;
    const done = await act(async () => {
      canBe = !id || (await maker.takeProgram(id));
    });
    if (done && !canBe) refuse(say.cannot);
  };
  return (
    <Loaded of={programs}>
      {(list) => (
        <label class="labelled">
          <span class="labelled__label">{say.program}</span>
          <Select
            value={chosen.value}
            testId="making-program"
            options={[
              ["", say.choose],
              ...list.map(({ id, name }): SelectOption<string> => [id, name]),
            ]}
            onChange={take}
          />
          <FaultLine fault={fault} />
        </label>
      )}
    </Loaded>
  );
}

const OF_SOLUTION = "";

function WorldAndInputs({ maker }: { maker: Maker }) {
  const { solution: say } = texts.value.making;
  const world = maker.stage.value?.world;
  const shown = typeof world === "string" ? world : OF_SOLUTION;
  const shipped = worlds.value.map(
    (one): SelectOption<string> => [one.name, worldTitle(one, language.value)],
  );
  const own: SelectOption<string>[] = shown === OF_SOLUTION ? [[OF_SOLUTION, say.ownWorld]] : [];
  const { fault, act } = useAct(asTeacher);
  const input = (name: "gestures" | "answers") => ({
    label: say[name],
    value: maker.inputs.value[name],
    placeholder: say.none,
    onText: (text: string) => {
      maker.inputs.value = { ...maker.inputs.value, [name]: text };
    },
    onBlur: () => void act(() => maker.measure()),
  });
  return (
    <div class="teacher__row">
      <label class="labelled">
        <span class="labelled__label">{say.world}</span>
        <Select
          value={shown}
          testId="making-world"
          options={[...own, ...shipped]}
          onChange={(name) => name && act(() => maker.takeWorld(name))}
        />
      </label>
      <Field {...input("gestures")} />
      <Field {...input("answers")} />
      <FaultLine fault={fault} />
    </div>
  );
}
