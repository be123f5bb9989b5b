interface EmptyListProps {
  title: string;
  text: string;
  testId: string;
}

/** Placeholder for an empty list of the review. */
export function EmptyList({ title, text, testId }: EmptyListProps) {
  return (
    <div class="review-empty" data-testid={testId}>
      <strong>{title}</strong>
      <p>{text}</p>
    </div>
  );
}
