;;; A small interpreter of SAUSAGES plans as `mlab build --emit sausages` writes them: which links are active, cycle by
;;; cycle, for given truth values of the conditions. docs/languages/exports.md says what it must do.
;;;
;;;   clisp -q -norc sausages.lisp PLAN CYCLES
;;;
;;; CYCLES holds one list a cycle: the conditions that are true. Prints one line a cycle: the names of the active steps,
;;; the outer ones first, with `/` between them.

(defun entry (key step)
  "What stands behind KEY in a step: (key value...)."
  (cdr (find-if (lambda (part) (and (consp part) (eq (car part) key))) (cdr step))))

(defun is-sequence (step) (eq (car step) 'sequence))

(defun steps (sequence)
  (remove-if-not (lambda (part) (and (consp part) (member (car part) '(sequence link)))) (cdr sequence)))

(defun step-of (sequence id)
  (or (find-if (lambda (step) (eql (car (entry 'plan-id step)) id)) (steps sequence))
      (error "no step ~A in this sequence" id)))

(defun holds (condition true-ones)
  (cond ((eq condition t) t)
        ((null condition) nil)
        ((and (consp condition) (eq (car condition) 'and))
         (every (lambda (one) (holds one true-ones)) (cdr condition)))
        ((and (consp condition) (eq (car condition) 'or))
         (some (lambda (one) (holds one true-ones)) (cdr condition)))
        ((and (consp condition) (eq (car condition) 'not)) (not (holds (cadr condition) true-ones)))
        (t (member condition true-ones :test #'equalp))))

(defun run (sequence current starts true-ones)
  "One cycle of a sequence. CURRENT: the active step of each, by identity. Returns the names of the active steps."
  (let* ((id (if starts (car (entry 'start sequence)) (gethash sequence current)))
         (way (find-if (lambda (one) (holds (car one) true-ones)) (entry 'transitions (step-of sequence id))))
         (target (if way (cadr way) id))
         (enters (or starts (/= target id) (and way (member 'restart way) t)))
         (step (step-of sequence target)))
    (setf (gethash sequence current) target)
    (cons (car (entry 'name step)) (when (is-sequence step) (run step current enters true-ones)))))

(defun read-all (file)
  (with-open-file (in file)
    (loop for form = (read in nil in) until (eq form in) collect form)))

(let* ((plan (find-if (lambda (form) (eq (car form) 'defplan)) (read-all (first *args*))))
       (top (fourth plan))
       (current (make-hash-table :test #'eq))
       (starts t))
  (dolist (true-ones (read-all (second *args*)))
    (format t "~{~A~^/~}~%" (run top current starts true-ones))
    (setf starts nil)))
