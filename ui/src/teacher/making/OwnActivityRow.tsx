import { Pencil, Trash2 } from "lucide-preact";
import type { OwnActivity } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { GoalPicture } from "../../scene/small/GoalPicture";

interface OwnActivityRowProps {
  activity: OwnActivity;
  onEdit(): Promise<void>;
  onDelete(): Promise<void>;
}

/** An activity that was made on this PC; shows the reason if this release cannot use it. */
export function OwnActivityRow({ activity, onEdit, onDelete }: OwnActivityRowProps) {
  const { making: labels } = texts.value;
  const { title, goal_picture, problem } = activity;
  return (
    <li class="making__row card row middle gap-4" data-testid="making-row">
      {goal_picture && (
        <div class="making__goal">
          <GoalPicture goal={goal_picture} />
        </div>
      )}
      <div class="making__words">
        <strong>{title}</strong>
        {problem && (
          <p class="notice-box">
            {problem.message} {problem.remedy}
          </p>
        )}
      </div>
      {!problem && (
        <Button
          icon={Pencil}
          label={labels.editOf({ title })}
          testId="making-edit"
          onPress={onEdit}
        >
          {labels.edit}
        </Button>
      )}
      <Button
        kind="plain"
        icon={Trash2}
        label={labels.deleteOf({ title })}
        testId="making-delete"
        onPress={onDelete}
      />
    </li>
  );
}
